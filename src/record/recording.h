// Recording of a run's steps in its probes and in history.csv.
#pragma once

#include "script/lua/objects.h"

namespace hinge::script {

double value_of(const Run& run, const Probe& probe);  ///< the probe's quantity now
double abscissa(const Run& run);                      ///< time, s; in statics the load factor
const char* unit_of(const Probe& probe);              ///< "m", "rad", "m/s", ..., "N m"
void keep_row(RunRecord& r, const Energy& energy, const LostBalance* lost = nullptr);  ///< for plots; see KeptRows
int run_history(lua_State* L);  ///< core.run_history(run): the recorded rows

/// A row of history.csv with these energies, and its line's end. `lost`: the balance that no longer closed, with probes
/// that are not numbers; null: that of the state.
std::string history_row(const RunRecord& record, const Energy& energy, const LostBalance* lost = nullptr);

/// The balance of a run whose energy no longer balanced, at the moment when this was seen; else null.
const LostBalance* lost_by(const RunRecord& record);
/// The energy error as a part of the largest energy: of the state, and of the run, which for a run whose balance no
/// longer closed is that of the moment at which this was seen, not that of the state to which it went back.
void weigh_error(RunRecord& record, const Energy& energy);

/// 12 s, 3 min 20 s, 2 h 5 min
std::string duration_text(double s);

}  // namespace hinge::script
