// core.pack_frames: the frames of a run as a page takes them, small and quick to open.
#include <zlib.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstring>

#include "script/snapshot.h"
#include "script/picture_module.h"

namespace hinge::script {
namespace {

using output::Bar;
using output::Snapshot;

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

std::string deflated(const std::string& bytes) {
    uLongf size = compressBound(uLong(bytes.size()));
    std::string out(size, '\0');
    if (compress2(reinterpret_cast<Bytef*>(out.data()), &size, reinterpret_cast<const Bytef*>(bytes.data()),
                  uLong(bytes.size()), 6) != Z_OK)
        throw OutsideError("the frames cannot be compressed: not enough memory");
    out.resize(size);
    return out;
}

/// Words, `a_frame` of them for each frame, as base64 of a zlib stream: of each frame its change since the frame
/// before, first the lowest byte of each word, then the next.
template <class Word>
std::string packed(const std::vector<Word>& words, std::size_t a_frame) {
    std::string bytes(words.size() * sizeof(Word), '\0');
    for (std::size_t from = 0; from < words.size(); from += a_frame)
        for (std::size_t i = 0; i < a_frame; ++i) {
            const Word change = Word(words[from + i] - (from > 0 ? words[from - a_frame + i] : Word(0)));
            for (std::size_t b = 0; b < sizeof(Word); ++b)
                bytes[from * sizeof(Word) + b * a_frame + i] = char(change >> (8 * b) & 0xff);
        }
    return base64(deflated(bytes));
}

std::uint32_t bits(double value) { return std::bit_cast<std::uint32_t>(static_cast<float>(value)); }

std::size_t declared_points(const Snapshot& s) {
    return std::size_t(std::count(s.is_virtual.begin(), s.is_virtual.end(), 0));
}
bool same_model(const Snapshot& a, const Snapshot& b) {
    return a.bars.size() == b.bars.size() && declared_points(a) == declared_points(b) && a.groups == b.groups;
}

constexpr double f_y_unit = 1.0 / 20000, force_unit = 1.0 / 32767;
std::array<double, 6> forces(const Bar& b) { return {b.N, b.Mx[0], b.Mx[1], b.My[0], b.My[1], b.Mz}; }

/// The table that a page takes; its arrays are described in src/viewer/src/run_data.js, which reads them.
class Pack {
public:
    Pack(lua_State* L, const std::vector<Snapshot>& frames) : L_(L), frames_(frames) {}

    void push() {
        lua_createtable(L_, 0, 20);
        const Snapshot& first = frames_[0];
        number("frames", double(frames_.size()));
        number("nodes", double(declared_points(first)));
        number("bars", double(first.bars.size()));
        list("times", [](const Snapshot& s) { return s.time; });
        if (first.factor) list("factors", [](const Snapshot& s) { return s.factor.value_or(0); });
        lua_createtable(L_, int(first.groups.size()), 0);
        for (std::size_t i = 0; i < first.groups.size(); ++i)
            lua_pushlstring(L_, first.groups[i].data(), first.groups[i].size()),
                lua_rawseti(L_, -2, lua_Integer(i) + 1);
        lua_setfield(L_, -2, "groups");
        push_model();
        push_positions();
        push_bars();
    }

private:
    void number(const char* name, double value) { lua_pushnumber(L_, value), lua_setfield(L_, -2, name); }
    void text(const char* name, const std::string& value) {
        lua_pushlstring(L_, value.data(), value.size()), lua_setfield(L_, -2, name);
    }
    template <class Value>
    void list(const char* name, Value value) {
        lua_createtable(L_, int(frames_.size()), 0);
        for (std::size_t i = 0; i < frames_.size(); ++i)
            lua_pushnumber(L_, value(frames_[i])), lua_rawseti(L_, -2, lua_Integer(i) + 1);
        lua_setfield(L_, -2, name);
    }

    /// Nodes as declared, supports, which nodes an element joins, its member; groups of the members.
    void push_model() {
        const Snapshot& first = frames_[0];
        const std::size_t nodes = declared_points(first);
        std::vector<std::uint32_t> at, ends(2 * first.bars.size(), ~0u), member, limits, width, of;
        for (std::size_t i = 0; i < nodes; ++i)
            for (std::size_t c = 0; c < 3; ++c)
                at.push_back(bits(first.points[i][c] - (first.displacement.empty() ? 0 : first.displacement[i][c])));
        for (const Snapshot& s : frames_)
            for (std::size_t b = 0; b < s.bars.size(); ++b)
                for (int side : {0, 1})
                    if (const int p = s.bars[b].point[side]; !s.is_virtual[p]) ends[2 * b + side] = std::uint32_t(p);
        for (const Bar& b : first.bars) {
            member.push_back(std::uint32_t(b.member));
            width.push_back(bits(b.width));
            for (double limit : {b.N0, b.Mx0, b.My0, b.Mz0}) limits.push_back(bits(limit));
        }
        for (const auto& [m, group] : first.memberships)
            of.push_back(std::uint32_t(m)), of.push_back(std::uint32_t(group));
        text("declared", packed(at, at.size()));
        text("held", packed(first.held, first.held.size()));
        text("ends", packed(ends, ends.size()));
        text("member", packed(member, member.size()));
        text("width", packed(width, width.size()));
        text("limits", packed(limits, limits.size()));
        text("memberships", packed(of, of.size()));
    }

    /// Nodes in each frame, and the loose ends of broken elements: how many, of which element and end, where.
    void push_positions() {
        std::vector<std::uint32_t> at, count, which, loose;
        const std::size_t nodes = declared_points(frames_[0]);
        for (const Snapshot& s : frames_) {
            for (std::size_t i = 0; i < nodes; ++i)
                for (double x : s.points[i]) at.push_back(bits(x));
            std::uint32_t n = 0;
            for (std::size_t b = 0; b < s.bars.size(); ++b)
                for (int side : {0, 1})
                    if (const int p = s.bars[b].point[side]; s.is_virtual[p]) {
                        ++n, which.push_back(std::uint32_t(2 * b + side));
                        for (double x : s.points[p]) loose.push_back(bits(x));
                    }
            count.push_back(n);
        }
        text("positions", packed(at, 3 * nodes));
        text("loose_count", packed(count, count.size()));
        text("loose_end", packed(which, which.size()));
        text("loose_at", packed(loose, loose.size()));
    }

    /// f_y, state and forces of each element in each frame; a force as a part of the largest it has in any.
    void push_bars() {
        const std::size_t bars = frames_[0].bars.size();
        std::vector<double> largest(6 * bars, 0);
        for (const Snapshot& s : frames_)
            for (std::size_t b = 0; b < bars; ++b)
                for (std::size_t c = 0; c < 6; ++c)
                    if (const double v = std::abs(forces(s.bars[b])[c]); v > largest[6 * b + c] && std::isfinite(v))
                        largest[6 * b + c] = v;
        std::vector<std::uint16_t> f_y, part;
        std::vector<std::uint8_t> state;
        const auto rounded = [](double value, double most) {
            return std::isfinite(value) ? std::lround(std::clamp(value, -most, most)) : 0L;
        };
        for (const Snapshot& s : frames_) {
            for (const Bar& b : s.bars) {
                f_y.push_back(std::uint16_t(rounded(b.yield / f_y_unit, 65535)));
                state.push_back(std::uint8_t(int(b.state) | (b.hinges & 7) << 2 | (b.touched ? 32 : 0)));
            }
            for (std::size_t c = 0; c < 6; ++c)
                for (std::size_t b = 0; b < bars; ++b) {
                    const double most = largest[6 * b + c];
                    part.push_back(std::uint16_t(
                        std::int16_t(most > 0 ? rounded(forces(s.bars[b])[c] / most / force_unit, 32767) : 0)));
                }
        }
        std::vector<std::uint32_t> scale;
        for (double v : largest) scale.push_back(bits(v * force_unit));
        text("f_y", packed(f_y, bars));
        text("state", packed(state, bars));
        text("forces", packed(part, 6 * bars));
        text("force_scale", packed(scale, scale.size()));
        number("f_y_unit", f_y_unit);
    }

    lua_State* L_;
    const std::vector<Snapshot>& frames_;
};

/// core.pack_frames(files): what a page takes of these frames, those of the last one's model; and how many were left
/// out.
int pack_frames(lua_State* L) {
    luaL_checktype(L, 1, LUA_TTABLE);
    const auto c = context(L);
    std::vector<std::string> files;
    for (lua_Integer i = 1, n = lua_Integer(lua_rawlen(L, 1)); i <= n; ++i) {
        lua_rawgeti(L, 1, i);
        files.emplace_back(lua_tostring(L, -1) ? lua_tostring(L, -1) : "");
        lua_pop(L, 1);
    }
    std::vector<Snapshot> frames;
    for (const std::string& file : files) {
        Snapshot& s = frames.emplace_back();
        char error[512] = "";
        if (picture_function<hinge_read_snapshot>(*c, "hinge_read_snapshot")(file.c_str(), s, error, sizeof error) != 0)
            throw OutsideError(error);
        if (s.held.empty()) s.held.assign(s.points.size(), 0);
    }
    const std::size_t all = frames.size();
    if (all == 0) return lua_pushnil(L), lua_pushinteger(L, 0), 2;
    std::vector<Snapshot> kept;
    for (Snapshot& s : frames)
        if (&s == &frames.back() || same_model(s, frames.back())) kept.push_back(std::move(s));
    for (Snapshot& s : kept) s.held.resize(declared_points(s));
    Pack(L, kept).push();
    lua_pushinteger(L, lua_Integer(all - kept.size()));
    return 2;
}

}  // namespace

void open_frames(lua_State* L, int module) {
    lua_pushvalue(L, module);
    lua_pushcfunction(L, guarded<pack_frames>);
    lua_setfield(L, -2, "pack_frames");
    lua_pop(L, 1);
}

}  // namespace hinge::script
