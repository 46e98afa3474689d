// Contact's state, kept: for a step that is undone, and as a record of bytes.
#include <algorithm>
#include <cstdint>
#include <cstring>

#include "contact/contact.h"

namespace hinge::contact {

// Saving and restoring run through one list of fields. Vectors and quaternions go number by number, so that no padding and no
// library's layout gets into the bytes.
namespace {

struct Writer {
    std::vector<char>& out;

    template <class T>
    void plain(T& value) {
        const char* bytes = reinterpret_cast<const char*>(&value);
        out.insert(out.end(), bytes, bytes + sizeof value);
    }
    template <class T, class Each>
    void list(std::vector<T>& values, Each each) {
        std::uint64_t n = values.size();
        plain(n);
        for (T& value : values) each(value);
    }
};

struct Reader {
    const char* at;
    std::size_t left;
    bool whole = true;

    template <class T>
    void plain(T& value) {
        whole = whole && left >= sizeof value;
        if (!whole) return;
        std::memcpy(&value, at, sizeof value);
        at += sizeof value;
        left -= sizeof value;
    }
    template <class T, class Each>
    void list(std::vector<T>& values, Each each) {
        std::uint64_t n = 0;
        plain(n);
        whole = whole && n <= left;  // every element takes a byte at least: no record makes us allocate more than its own size
        values.clear();
        for (std::uint64_t i = 0; i < n && whole; ++i) {
            values.emplace_back();
            each(values.back());
        }
    }
};

template <class Io, class... T>
void plain(Io& io, T&... values) {
    (io.plain(values), ...);
}

template <class Io>
void vector(Io& io, Vec3& v) {
    plain(io, v[0], v[1], v[2]);
}

}  // namespace

template <class Io>
void Contact::fields(Io& io) {
    plain(io, counts_.bound, counts_.released, counts_.dropped, counts_.pair_tests, counts_.list_builds, counts_.energy_let_go);
    io.list(rules_, [&](ContactSettings& r) {
        plain(io, r.rule, r.sleep, r.stiffness, r.friction, r.reach, r.flatness, r.binding_time, r.letter, r.hold_until_parting, r.parting_energy,
              r.longest_hold, r.shortest_gap);
    });
    io.list(bonds_, [&](Bond& bond) {
        plain(io, bond.element[0], bond.element[1], bond.rule, bond.since);
        for (End& end : bond.end) {
            plain(io, end.node);
            vector(io, end.arm);
        }
        for (Gap& gap : bond.gap) {
            vector(io, gap.rest);
            plain(io, gap.stiffness);
        }
        vector(io, bond.side);
        vector(io, bond.side_now);
        plain(io, bond.at[0], bond.at[1], bond.energy, bond.opening);
        plain(io, bond.turn.coeffs()[0], bond.turn.coeffs()[1], bond.turn.coeffs()[2], bond.turn.coeffs()[3]);
        plain(io, bond.energy_before, bond.opening_before, bond.energy_peak, bond.falling);
        for (Vec3& f : bond.force) vector(io, f);
    });
    io.list(touches_, [&](Touch& touch) {
        plain(io, touch.element[0], touch.element[1], touch.radius[0], touch.radius[1], touch.stiffness, touch.friction);
        for (End& end : touch.end) {
            plain(io, end.node);
            vector(io, end.arm);
        }
        plain(io, touch.overlap, touch.energy, touch.at[0], touch.at[1], touch.heat, touch.slides);
        plain(io, touch.overlap_before, touch.at_before[0], touch.at_before[1]);
        for (Vec3* v : {&touch.side, &touch.slip, &touch.between, &touch.side_before, &touch.slip_before, &touch.between_before}) vector(io, *v);
        for (Quat& q : touch.turn_before) plain(io, q.coeffs()[0], q.coeffs()[1], q.coeffs()[2], q.coeffs()[3]);
    });
    plain(io, stored_);
    io.list(events_, [&](ContactEvent& event) { plain(io, event.time, event.element[0], event.element[1], event.bound); });
    plain(io, seen_, now_, travelled_, listed_at_, margin_);
    io.list(nodes_, [&](int& node) { plain(io, node); });
    io.list(last_, [&](Vec3& x) { vector(io, x); });
    io.list(arms_, [&](ArmEnd& arm) {
        plain(io, arm.end.node);
        vector(io, arm.end.arm);
        vector(io, arm.last);
    });
    io.list(candidates_, [&](Candidate& pair) {
        plain(io, pair.element[0], pair.element[1], pair.bar[0], pair.bar[1], pair.state, pair.rule, pair.touch);
        vector(io, pair.side);
    });
    io.list(look_at_, [&](double& at) { plain(io, at); });
}

void Contact::remember() {
    noting_ = true;
    before_.all_but_pairs = all_but_pairs();
    before_.changed.clear();
    before_.listed_anew = false;
}

void Contact::take_back() {
    all_but_pairs() = before_.all_but_pairs;
    if (before_.listed_anew) candidates_ = before_.candidates, look_at_ = before_.look_at;
    for (auto c = before_.changed.rbegin(); c != before_.changed.rend(); ++c) candidates_[c->place] = c->pair, look_at_[c->place] = c->look_at;
    before_.changed.clear();
    before_.listed_anew = false;
}

void Contact::note_pair(std::size_t place) {
    if (noting_ && !before_.listed_anew) before_.changed.push_back({place, candidates_[place], look_at_[place]});
}

void Contact::note_list() {
    if (!noting_ || before_.listed_anew) return;
    before_.listed_anew = true;
    before_.candidates = candidates_, before_.look_at = look_at_;
}

void Contact::save(std::vector<char>& out) const {
    Writer writer{out};
    const_cast<Contact*>(this)->fields(writer);  // a writer changes nothing
}

std::size_t Contact::restore(const char* data, std::size_t size) {
    Contact read(rules_);
    Reader reader{data, size};
    read.fields(reader);
    const auto unknown = [&](const auto& of) { return of.rule < 0 || std::size_t(of.rule) >= read.rules_.size(); };
    if (std::any_of(read.bonds_.begin(), read.bonds_.end(), unknown) || std::any_of(read.candidates_.begin(), read.candidates_.end(), unknown)) return 0;
    if (!reader.whole || read.last_.size() != read.nodes_.size() || read.look_at_.size() != read.candidates_.size()) return 0;
    *this = std::move(read);
    return size - reader.left;
}

}  // namespace hinge::contact
