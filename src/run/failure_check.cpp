#include "run/failure_check.h"

#include <algorithm>

#include "model/structure.h"

namespace hinge {
namespace {

template <class Kind>
bool is_one_of(Kind kind, Kind last) {
    return int(kind) >= 0 && int(kind) <= int(last);
}

/// What the text of a cause needs.
bool has_subject(const Failure& f) {
    switch (f.cause) {
        case Cause::load_not_finite:
        case Cause::forces_unbounded:
        case Cause::rotation_too_large: return f.node >= 0;
        case Cause::force_not_finite: return f.node >= 0 || f.element >= 0;
        case Cause::element_folded:
        case Cause::flow_not_found: return f.element >= 0;
        default: return true;
    }
}

bool makes_sense(const Failure& f, const Structure& s) {
    const auto below = [](int i, std::size_t end) { return i >= -1 && i < int(end); };
    return is_one_of(f.cause, Cause::unstable) && below(f.node, s.position().size()) &&
           below(f.other, s.position().size()) && below(f.element, s.elements().size()) && below(f.component, 6) &&
           has_subject(f);
}

bool makes_sense(const Remark& r, const Structure& s) {
    using Kind = Remark::Kind;
    if (!is_one_of(r.kind, Kind::follow_in_time) || !makes_sense(r.of, s)) return false;
    switch (r.kind) {
        case Kind::pressed_flat: return r.of.element >= 0;
        case Kind::fastest: return r.of.node >= 0;
        case Kind::limit_point:
        case Kind::not_moved:
        case Kind::would_turn_back:
        case Kind::drive_displacement: return r.of.node >= 0 && r.of.component >= 0;
        default: return true;
    }
}

}  // namespace

bool makes_sense(const RunFailure& f, const Structure& s) {
    return makes_sense(f.what, s) && std::ranges::all_of(f.remarks, [&](const Remark& r) { return makes_sense(r, s); });
}

}  // namespace hinge
