#include "record/drawing_order.h"

#include "core/archive.h"

namespace hinge {
namespace {

using output::Bar, output::Load, output::Plane, output::Shape, output::Snapshot, output::View;

template <class A, class Array>
void array(A& a, Array& v) {
    for (auto& each : v) a(each);
}

/// A list: its length, then each(entry).
template <class A, class List, class Each>
void list(A& a, List& v, Each each) {
    std::uint64_t n = v.size();
    a(n);
    if constexpr (A::reading) {
        a.must_hold(n, 1);
        v.clear();
        for (std::uint64_t i = 0; i < n; ++i) each(v.emplace_back());
    } else {
        for (auto& entry : v) each(entry);
    }
}

template <class A, class Lists>
void arrays(A& a, Lists& v) {
    list(a, v, [&](auto& each) { array(a, each); });
}

template <class A, class B>
void bar(A& a, B& b) {
    a(b.point, b.yield, b.state, b.group, b.member, b.element, b.width, b.N, b.Mx, b.My, b.Mz, b.Qx, b.Qy,
      b.compression, b.N0, b.Mx0, b.My0, b.Mz0, b.hinges, b.touched, b.rotation, b.shape, b.node, b.yield_along);
    array(a, b.up);
}

template <class A, class S>
void snapshot(A& a, S& s) {
    a(s.time, s.factor, s.is_virtual, s.held, s.declared, s.groups, s.laws, s.joints);
    arrays(a, s.points), arrays(a, s.displacement), arrays(a, s.rotation);
    arrays(a, s.memberships), arrays(a, s.connected);
    list(a, s.bars, [&](auto& b) { bar(a, b); });
    list(a, s.shapes, [&](auto& each) { a(each.kind, each.width, each.depth, each.web, each.flange); });
    for (auto* loads : {&s.loads, &s.weights})
        list(a, *loads, [&](auto& each) {
            a(each.kind, each.point, each.bar, each.at, each.from, each.to);
            array(a, each.value[0]), array(a, each.value[1]);
        });
    list(a, s.floors, [&](auto& p) {
        a(p.points, p.has_forces, p.force[0], p.force[1], p.torn, p.membrane[0], p.membrane[1], p.membrane[2], p.used);
    });
    list(a, s.ground, [&](auto& each) { array(a, each.point), array(a, each.normal); });
}

template <class A, class V>
void view(A& a, V& v) {
    a(v.width, v.height, v.parallel, v.scale, v.show, v.largest, v.ghost, v.supports, v.ground, v.hinges, v.floors,
      v.loads, v.node_labels, v.member_labels, v.leave_out_broken, v.above, v.groups, v.title);
    array(a, v.from), array(a, v.up), array(a, v.plane);
    bool boxed = v.box.has_value();
    a(boxed);
    if constexpr (A::reading)
        if (boxed) v.box.emplace();
    if (boxed) array(a, *v.box);
}

template <class A, class O>
void order(A& a, O& o) {
    a(o.what, o.path, o.columns, o.frames, o.plot);
    list(a, o.snapshots, [&](auto& s) { snapshot(a, s); });
    list(a, o.views, [&](auto& v) { view(a, v); });
}

}  // namespace

std::string to_bytes(const DrawingOrder& o) {
    std::string bytes;
    Writer writer(bytes);
    order(writer, o);
    return bytes;
}

DrawingOrder order_from_bytes(std::string_view bytes) {
    DrawingOrder o;
    Reader reader(bytes);
    order(reader, o);
    reader.must(reader.rest().empty());
    return o;
}

}  // namespace hinge
