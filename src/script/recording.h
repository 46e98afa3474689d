// Recording: what a run's steps leave in its probes and in history.csv.
#pragma once

#include "script/objects.h"

namespace hinge::script {

double value_of(const Run& run, const Probe& probe);  ///< the probe's quantity now
double abscissa(const Run& run);                      ///< time, s; in statics the load factor

}  // namespace hinge::script
