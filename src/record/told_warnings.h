// Prints warnings and notices, each once, and writes them as events.
#pragma once

#include "record/context.h"
#include "record/run_record.h"

namespace hinge {

/// Prints a likely mistake, once.
void tell(Context& c, const Warning& w);

/// Prints the findings of effects on a run as a whole, when it ends or is left; nothing for a run without a step.
void tell_findings(Context& c, const RunRecord& r);

/// hinge run: prints likely mistakes, each once, in ten lines at most; of a model before its run, and of the run.
void look_over(Context& c, const Model& model);
void look_over(Context& c, RunRecord& record);

/// Prints at 100,000 declared members, and at each doubling.
void tell_members(const Context& c, std::size_t members);

/// Prints the size of a large model, before it is built.
void tell_size(Context& c, const Model& model);

/// Prints a notice of advice/size_notice.h; nothing for "".
void tell_notice(Context& c, const std::string& text);

}  // namespace hinge
