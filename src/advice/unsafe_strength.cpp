#include "advice/unsafe_strength.h"

#include <algorithm>
#include <cmath>

#include "core/text.h"

namespace hinge {

std::string excess_text(double excess) { return number_text(std::round(100 * excess), 4) + " %"; }

std::string when_text(const Workspace& w, double at) {
    return w.goes_by_load_factor() ? "at load factor " + number_text(at, 4) : "at t = " + number_text(at, 4) + " s";
}

void UnsafeMembers::add(const Model& model, int member) {
    if (is_unsafe_.empty()) is_unsafe_.assign(model.members().size(), 0);
    is_unsafe_[std::size_t(member)] = 1;
}

long UnsafeMembers::others() const { return std::count(is_unsafe_.begin(), is_unsafe_.end(), 1) - 1; }

}  // namespace hinge
