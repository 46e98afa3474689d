#include "record/frame_pack.h"

#include <zlib.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>
#include <set>

#include "core/bar_bending.h"
#include "core/errors.h"

namespace hinge {
namespace {

using output::Bar;
using output::Snapshot;

std::string deflated(const std::string& bytes, Packing packing) {
    uLongf size = compressBound(uLong(bytes.size()));
    std::string out(size, '\0');
    if (compress2(reinterpret_cast<Bytef*>(out.data()), &size, reinterpret_cast<const Bytef*>(bytes.data()),
                  uLong(bytes.size()), int(packing)) != Z_OK)
        throw OutsideError("the frames cannot be compressed: not enough memory");
    out.resize(size);
    return out;
}

/// Words, `a_frame` of them for each frame, as base64 of a zlib stream: of each frame its change since the frame
/// before, first the lowest byte of each word, then the next.
template <class Word>
std::string packed(const std::vector<Word>& words, std::size_t a_frame, Packing packing) {
    std::string bytes(words.size() * sizeof(Word), '\0');
    for (std::size_t from = 0; from < words.size(); from += a_frame)
        for (std::size_t i = 0; i < a_frame; ++i) {
            const Word change = Word(words[from + i] - (from > 0 ? words[from - a_frame + i] : Word(0)));
            for (std::size_t b = 0; b < sizeof(Word); ++b)
                bytes[from * sizeof(Word) + b * a_frame + i] = char(change >> (8 * b) & 0xff);
        }
    return base64(deflated(bytes, packing));
}

std::uint32_t bits(double value) { return std::bit_cast<std::uint32_t>(static_cast<float>(value)); }

std::size_t declared_points(const Snapshot& s) {
    return std::size_t(std::count(s.is_virtual.begin(), s.is_virtual.end(), 0));
}

constexpr double f_y_unit = 1.0 / 20000, force_unit = 1.0 / 32767;
std::array<double, 6> forces(const Bar& b) { return {b.N, b.Mx[0], b.Mx[1], b.My[0], b.My[1], b.Mz}; }

/// dMx/dz = Qy and dMy/dz = -Qx; what rounding leaves is zero, or it would be packed as if it were forces.
std::array<double, 4> sags(const Snapshot& s, const Bar& b) {
    const auto &p = s.points[std::size_t(b.point[0])], &q = s.points[std::size_t(b.point[1])];
    const double length = std::hypot(q[0] - p[0], q[1] - p[1], q[2] - p[2]);
    std::array<double, 4> out{};
    for (const int axis : {0, 1}) {
        const double(&M)[2] = axis == 0 ? b.Mx : b.My;
        const double(&Q)[2] = axis == 0 ? b.Qy : b.Qx;
        const double sign = axis == 0 ? length : -length, chord = M[1] - M[0];
        if (b.compression[axis] != 0) {
            BarBending bent{{M[0], M[1]}, {Q[0], Q[1]}, axis == 0 ? 1.0 : -1.0, length};
            bent.compression = b.compression[axis];
            bent.close();
            const auto off = [&](double t) { return bent.moment(t) - M[0] - t * chord; };
            out[2 * axis] = off(0.5), out[2 * axis + 1] = (off(0.25) - off(0.75)) * 32 / 3;
            continue;
        }
        if (Q[0] == 0 && Q[1] == 0) continue;  // frames of earlier versions have none
        const double first = sign * Q[0] - chord, last = sign * Q[1] - chord;
        const double noise = 1e-5 * (std::abs(M[0]) + std::abs(M[1]) + length * (std::abs(Q[0]) + std::abs(Q[1])));
        if (const double d = (first - last) / 8; std::abs(d) > noise) out[2 * axis] = d;
        if (const double c = first + last; std::abs(c) > noise) out[2 * axis + 1] = c;
    }
    return out;
}

class Pack {
public:
    Pack(const std::vector<const Snapshot*>& frames, Packing packing) : frames_(frames), packing_(packing) {}

    Json json(bool with_model) {
        const Snapshot& first = *frames_[0];
        j_["frames"] = frames_.size();
        j_["nodes"] = declared_points(first);
        j_["bars"] = first.bars.size();
        for (const Snapshot* s : frames_) j_["times"].push_back(s->time);
        if (first.factor)
            for (const Snapshot* s : frames_) j_["factors"].push_back(s->factor.value_or(0));
        if (with_model) add_model();
        add_positions();
        add_bars();
        add_plates();
        return std::move(j_);
    }

private:
    template <class Word>
    void put(const char* name, const std::vector<Word>& words, std::size_t a_frame) {
        j_[name] = packed(words, a_frame, packing_);
    }
    template <class Word>
    void put(const char* name, const std::vector<Word>& words) {
        put(name, words, words.size());
    }

    /// Nodes as declared, supports, which nodes an element joins, its member; groups of the members.
    void add_model() {
        const Snapshot& first = *frames_[0];
        const std::size_t nodes = declared_points(first);
        std::vector<std::uint32_t> at, ends(2 * first.bars.size(), ~0u), member, limits, width, of, connected;
        std::vector<std::uint8_t> held = first.held, up;
        held.resize(nodes);
        for (std::size_t i = 0; i < nodes; ++i)
            for (std::size_t c = 0; c < 3; ++c)
                at.push_back(bits(first.points[i][c] - (first.displacement.empty() ? 0 : first.displacement[i][c])));
        // In frames of earlier versions an element that has broken off does not say where it was declared to end.
        for (const Snapshot* s : frames_)
            for (std::size_t b = 0; b < s->bars.size(); ++b)
                for (int side : {0, 1}) {
                    const Bar& bar = s->bars[b];
                    const int p = bar.node[side] >= 0 ? bar.node[side] : bar.point[side];
                    if (!s->is_virtual[p]) ends[2 * b + side] = std::uint32_t(p);
                }
        for (const auto& pair : first.connected)
            for (const int p : pair) connected.push_back(std::uint32_t(p));
        for (const Bar& b : first.bars) {
            member.push_back(std::uint32_t(b.member));
            width.push_back(bits(b.width));
            for (double limit : {b.N0, b.Mx0, b.My0, b.Mz0}) limits.push_back(bits(limit));
            for (double c : b.up)
                up.push_back(
                    std::uint8_t(std::int8_t(std::isfinite(c) ? std::lround(127 * std::clamp(c, -1.0, 1.0)) : 0)));
        }
        for (const auto& [m, group] : first.memberships)
            of.push_back(std::uint32_t(m)), of.push_back(std::uint32_t(group));
        j_["groups"] = first.groups;
        if (!first.laws.empty()) j_["laws"] = first.laws;
        j_["declared_nodes"] = first.declared;
        put("declared", at);
        put("held", held);
        put("ends", ends);
        put("member", member);
        put("width", width);
        put("up", up);
        put("limits", limits);
        put("memberships", of);
        put("connected", connected);
        std::vector<std::uint32_t> corners;  // four a plate; ~0: a triangle has three
        for (const output::Panel& p : first.floors)
            for (std::size_t k = 0; p.has_forces && k < 4; ++k)
                corners.push_back(k < p.points.size() ? std::uint32_t(p.points[k]) : ~0u);
        if (!corners.empty()) put("plates", corners);
    }

    /// Nodes in each frame, and the loose ends of broken elements: how many, of which element and end, where.
    void add_positions() {
        std::vector<std::uint32_t> at, count, which, loose;
        const std::size_t nodes = declared_points(*frames_[0]);
        for (const Snapshot* s : frames_) {
            for (std::size_t i = 0; i < nodes; ++i)
                for (double x : s->points[i]) at.push_back(bits(x));
            std::uint32_t n = 0;
            for (std::size_t b = 0; b < s->bars.size(); ++b)
                for (int side : {0, 1})
                    if (const int p = s->bars[b].point[side]; s->is_virtual[p]) {
                        ++n, which.push_back(std::uint32_t(2 * b + side));
                        for (double x : s->points[p]) loose.push_back(bits(x));
                    }
            count.push_back(n);
        }
        put("positions", at, 3 * nodes);
        put("loose_count", count);
        put("loose_end", which);
        put("loose_at", loose);
    }

    /// f_y, state and forces of each element in each frame; a force as a part of the largest it has in any.
    void add_bars() {
        const std::size_t bars = frames_[0]->bars.size();
        std::vector<double> largest(6 * bars, 0);
        for (const Snapshot* s : frames_)
            for (std::size_t b = 0; b < bars; ++b)
                for (std::size_t c = 0; c < 6; ++c)
                    if (const double v = std::abs(forces(s->bars[b])[c]); v > largest[6 * b + c] && std::isfinite(v))
                        largest[6 * b + c] = v;
        std::vector<std::uint16_t> f_y, part;
        std::vector<std::uint8_t> state;
        const auto rounded = [](double value, double most) {
            return std::isfinite(value) ? std::lround(std::clamp(value, -most, most)) : 0L;
        };
        for (const Snapshot* s : frames_) {
            for (const Bar& b : s->bars) {
                f_y.push_back(std::uint16_t(rounded(b.yield / f_y_unit, 65535)));
                state.push_back(std::uint8_t(int(b.state) | (b.hinges & 7) << 2 | (b.touched ? 32 : 0)));
            }
            for (std::size_t c = 0; c < 6; ++c)
                for (std::size_t b = 0; b < bars; ++b) {
                    const double most = largest[6 * b + c];
                    part.push_back(std::uint16_t(
                        std::int16_t(most > 0 ? rounded(forces(s->bars[b])[c] / most / force_unit, 32767) : 0)));
                }
        }
        std::vector<std::uint32_t> scale;
        scale.reserve(largest.size());
        for (double v : largest) scale.push_back(bits(v * force_unit));
        put("f_y", f_y, bars);
        put("state", state, bars);
        put("forces", part, 6 * bars);
        put("force_scale", scale);
        j_["f_y_unit"] = f_y_unit;
        add_yield_along();
        add_sags();
    }

    /// The larger principal force of each plate in each frame, with its sign, as a part of the largest of all; of one
    /// that has torn, the least number there is.
    void add_plates() {
        double largest = 0;
        std::vector<double> values;
        for (const Snapshot* s : frames_)
            for (const output::Panel& p : s->floors) {
                if (!p.has_forces) continue;
                const double force = std::abs(p.force[0]) >= std::abs(p.force[1]) ? p.force[0] : p.force[1];
                values.push_back(p.torn ? std::numeric_limits<double>::quiet_NaN() : force);
                if (std::isfinite(values.back())) largest = std::max(largest, std::abs(force));
            }
        if (values.empty() || values.size() % frames_.size() != 0) return;
        std::vector<std::uint16_t> part;
        for (const double v : values)
            part.push_back(std::uint16_t(std::int16_t(!std::isfinite(v) ? -32768
                                                      : largest > 0     ? std::lround(v / largest / force_unit)
                                                                        : 0)));
        put("plate_forces", part, values.size() / frames_.size());
        j_["plate_scale"] = largest * force_unit;
    }

    /// f_y of laws that are not eq 14, at the ends and in the middle of each element; 65535: eq 14.
    void add_yield_along() {
        const auto has_own = [](const Bar& b) { return b.yield_along[0] >= 0; };
        if (std::ranges::none_of(frames_, [&](const Snapshot* s) { return std::ranges::any_of(s->bars, has_own); }))
            return;
        constexpr double of_eq14 = 65535;
        std::vector<std::uint16_t> along;
        for (const Snapshot* s : frames_)
            for (const Bar& b : s->bars)
                for (const double f_y : b.yield_along) {
                    const double steps = std::isfinite(f_y) ? std::round(f_y / f_y_unit) : 0;
                    along.push_back(std::uint16_t(has_own(b) ? std::clamp(steps, 0.0, of_eq14 - 1) : of_eq14));
                }
        put("f_y_along", along, 3 * frames_[0]->bars.size());
    }

    /// How moments differ from a straight line between an element's ends, where loads or weight act there: of Mx, then
    /// of My, the difference at the middle, and by how much the sum of the slopes at both ends differs. And the
    /// elements with loads at points, or moments, between their ends, of which that is not all.
    void add_sags() {
        const std::size_t bars = frames_[0]->bars.size();
        std::set<std::uint32_t> pointed;
        std::vector<double> values, largest(4 * bars, 0);  // all of a frame, then those of the next
        for (const Snapshot* s : frames_) {
            for (const output::Load& l : s->loads)
                if (l.bar >= 0 && (l.at >= 0 || l.kind == output::Load::moment)) pointed.insert(std::uint32_t(l.bar));
            const std::size_t from = values.size();
            values.resize(from + 4 * bars);
            for (std::size_t b = 0; b < bars; ++b) {
                const auto sag = sags(*s, s->bars[b]);
                for (std::size_t c = 0; c < 4; ++c) {
                    values[from + c * bars + b] = sag[c];
                    largest[4 * b + c] = std::max(largest[4 * b + c], std::abs(sag[c]));
                }
            }
        }
        if (std::ranges::all_of(largest, [](double v) { return v == 0; }) && pointed.empty()) return;
        std::vector<std::uint16_t> part;
        for (std::size_t i = 0; i < values.size(); ++i) {
            const double most = largest[4 * (i % bars) + i / bars % 4];
            part.push_back(std::uint16_t(std::int16_t(most > 0 ? std::lround(values[i] / most / force_unit) : 0)));
        }
        std::vector<std::uint32_t> scale;
        scale.reserve(largest.size());
        for (double v : largest) scale.push_back(bits(v * force_unit));
        put("sags", part, 4 * bars);
        put("sag_scale", scale);
        put("pointed", std::vector<std::uint32_t>(pointed.begin(), pointed.end()));
    }

    Json j_;
    const std::vector<const Snapshot*>& frames_;
    Packing packing_;
};

}  // namespace

bool same_model(const Snapshot& a, const Snapshot& b) {
    return a.bars.size() == b.bars.size() && declared_points(a) == declared_points(b) && a.groups == b.groups;
}

std::string base64(const std::string& bytes) {
    static constexpr char digits[] = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    std::string text;
    text.reserve((bytes.size() + 2) / 3 * 4);
    for (std::size_t i = 0; i < bytes.size(); i += 3) {
        std::uint32_t word = 0;
        for (std::size_t k = 0; k < 3; ++k)
            word = word << 8 | (i + k < bytes.size() ? std::uint8_t(bytes[i + k]) : std::uint8_t(0));
        for (std::size_t k = 0; k < 4; ++k) text += i + k <= bytes.size() ? digits[word >> (18 - 6 * k) & 63] : '=';
    }
    return text;
}

Json packed_frames(const std::vector<const Snapshot*>& frames, Packing packing, bool with_model) {
    return Pack(frames, packing).json(with_model);
}

}  // namespace hinge
