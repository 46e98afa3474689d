// What the tests of the output module share: its functions as the program loads them, a small frame, and the pixels of
// a PNG.
#pragma once

#include <catch2/catch.hpp>

#include <dlfcn.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <set>
#include <string>
#include <tuple>
#include <vector>

#include "output/picture.h"

namespace hinge::output::test {

namespace fs = std::filesystem;

extern const char* const output_module_path;  ///< output_module.cpp

template <class Function>
Function load(const char* name) {
    static void* module = ::dlopen(output_module_path, RTLD_NOW | RTLD_LOCAL);
    INFO((module ? "" : ::dlerror()));
    REQUIRE(module);
    const auto function = reinterpret_cast<Function>(::dlsym(module, name));
    INFO(name);
    REQUIRE(function);
    return function;
}

/// What the call said: empty when it succeeded.
template <class Call>
std::string said(Call call) {
    char error[512] = "";
    const int status = call(error, static_cast<int>(sizeof error));
    CHECK((status == 0) == (error[0] == '\0'));
    return error;
}

inline std::string write(const std::string& path, const Snapshot& snapshot) {
    return said([&](char* e, int room) {
        return load<hinge_write_snapshot>("hinge_write_snapshot")(path.c_str(), snapshot, e, room);
    });
}

inline std::string read(const std::string& path, Snapshot& snapshot) {
    return said([&](char* e, int room) {
        return load<hinge_read_snapshot>("hinge_read_snapshot")(path.c_str(), snapshot, e, room);
    });
}

inline std::string render(const std::string& path, const Snapshot& snapshot, const View& view) {
    return said(
        [&](char* e, int room) { return load<hinge_render>("hinge_render")(path.c_str(), snapshot, view, e, room); });
}

class Folder {
public:
    Folder() {
        std::string name = (fs::temp_directory_path() / "hinge-output-XXXXXX").string();
        REQUIRE(::mkdtemp(name.data()));
        path_ = name;
    }
    ~Folder() {
        std::error_code ignored;
        fs::remove_all(path_, ignored);
    }
    Folder(const Folder&) = delete;
    Folder& operator=(const Folder&) = delete;
    std::string operator/(const std::string& name) const { return (path_ / name).string(); }
    std::size_t files() const { return static_cast<std::size_t>(std::distance(fs::directory_iterator(path_), {})); }

private:
    fs::path path_;
};

inline std::string contents(const std::string& path) {
    std::ifstream file(path, std::ios::binary);
    return {std::istreambuf_iterator<char>(file), {}};
}

/// A portal frame of `bays` bays, f_y rising from 0 to 1 along it, its last beam broken.
inline Snapshot portal(int bays) {
    Snapshot snapshot;
    snapshot.time = 0.125;
    snapshot.groups = {"columns", "beams"};
    int element = 0;
    const auto bar = [&](int a, int b, int group) {
        ++element;
        snapshot.bars.push_back(
            {{a, b}, std::min(1.0, 0.07 * element), BarState::elastic, group, element, element, 0.3});
    };
    for (int i = 0; i <= bays; ++i) {
        snapshot.points.push_back({4.0 * i, 0, 0});
        snapshot.points.push_back({4.0 * i, 0, 3});
        bar(2 * i, 2 * i + 1, 0);
        if (i > 0) bar(2 * i - 1, 2 * i + 1, 1);
    }
    snapshot.is_virtual.assign(snapshot.points.size(), 0);
    snapshot.points.push_back({4.0 * bays - 1, 0.2, 2.5});
    snapshot.is_virtual.push_back(1);
    snapshot.bars.back().point[1] = static_cast<int>(snapshot.points.size()) - 1;
    snapshot.bars.back().state = BarState::broken;
    for (std::size_t i = 0; i < snapshot.points.size(); ++i) {
        snapshot.displacement.push_back({0.25 * double(i), -0.5, 0.125});
        snapshot.rotation.push_back({0.5, 0.0625 * double(i), 0});
        snapshot.held.push_back(i == 0 ? 63 : 0);
    }
    for (Bar& b : snapshot.bars) {
        const double k = b.element;  // numbers that a float holds
        b.N = -64 * k, b.Mx[0] = k, b.Mx[1] = 2 * k, b.My[0] = 3 * k, b.My[1] = 4 * k, b.Mz = 5 * k;
        b.N0 = 128 * k, b.Mx0 = 8 * k, b.My0 = 9 * k, b.Mz0 = 10 * k;
        b.Qx[0] = k, b.Qx[1] = 2 * k, b.Qy[0] = 3 * k, b.Qy[1] = 4 * k;
        b.rotation[0] = 0.25 * k, b.rotation[1] = 0.5 * k;
        b.node[0] = b.point[0], b.node[1] = b.state == BarState::broken ? 2 * bays + 1 : b.point[1];
        b.up = {0, 0, 1}, b.shape = b.group;
        b.hinges = std::uint8_t(b.element & 7), b.touched = std::uint8_t(b.element & 1);
        snapshot.memberships.push_back({b.member, b.group});
    }
    snapshot.shapes = {{Shape::h, 0.3, 0.5, 0.0125, 0.025}, {Shape::round, 0.2, 0.2, 0, 0}};
    snapshot.loads = {{Load::force, 1, -1, -1, {{1, 2, 3}, {0, 0, 0}}},
                      {Load::moment, -1, 0, 0.5, {{4, 5, 6}, {0, 0, 0}}},
                      {Load::force, -1, 0, -1, {{0, 0, -7}, {0, 0, -8}}}};
    snapshot.connected = {{0, 3}, {1, 2}};
    snapshot.floors = {{{0, 1, 3, 2}}, {{1, 3, 2}}};
    snapshot.ground = {{{0, 0, -0.1}, {0, 0, 1}}};
    snapshot.declared = 2 * (bays + 1);
    return snapshot;
}

/// A load, a bar, but for the numbers that a file has as floats.
inline auto fields_of(const Load& l) { return std::tuple{l.kind, l.point, l.bar, l.at, l.value[0], l.value[1]}; }
inline auto fields_of(const Bar& b) {
    const std::array forces{b.N,   b.Mx[0], b.Mx[1], b.My[0], b.My[1], b.Mz,    b.N0,          b.Mx0,
                            b.My0, b.Mz0,   b.Qx[0], b.Qx[1], b.Qy[0], b.Qy[1], b.rotation[0], b.rotation[1]};
    return std::tuple{b.point[0], b.point[1], b.node[0], b.node[1], b.state,  b.group,  b.member,
                      b.element,  forces,     b.up,      b.shape,   b.hinges, b.touched};
}

inline void check_same(const Snapshot& a, const Snapshot& b) {
    CHECK(a.time == b.time);
    CHECK(a.points == b.points);
    CHECK(a.is_virtual == b.is_virtual);
    CHECK(a.groups == b.groups);
    CHECK(a.displacement == b.displacement);
    CHECK(a.held == b.held);
    CHECK(a.memberships == b.memberships);
    CHECK(a.rotation == b.rotation);
    CHECK(a.connected == b.connected);
    CHECK(a.declared == b.declared);
    CHECK(a.shapes == b.shapes);
    REQUIRE(a.loads.size() == b.loads.size());
    for (std::size_t i = 0; i < a.loads.size(); ++i) CHECK((fields_of(a.loads[i]) == fields_of(b.loads[i])));
    REQUIRE(a.floors.size() == b.floors.size());
    for (std::size_t i = 0; i < a.floors.size(); ++i) CHECK(a.floors[i].points == b.floors[i].points);
    REQUIRE(a.ground.size() == b.ground.size());
    for (std::size_t i = 0; i < a.ground.size(); ++i)
        CHECK((a.ground[i].point == b.ground[i].point && a.ground[i].normal == b.ground[i].normal));
    REQUIRE(a.bars.size() == b.bars.size());
    for (std::size_t i = 0; i < a.bars.size(); ++i) {
        INFO("bar " << i);
        CHECK((fields_of(a.bars[i]) == fields_of(b.bars[i])));
        CHECK(a.bars[i].yield == Approx(b.bars[i].yield).epsilon(1e-7));
        CHECK(a.bars[i].width == Approx(b.bars[i].width).epsilon(1e-7));
    }
}

inline std::uint32_t big_endian(const std::string& bytes, std::size_t at) {
    std::uint32_t value = 0;
    for (std::size_t i = 0; i < 4; ++i) value = value << 8 | static_cast<std::uint8_t>(bytes.at(at + i));
    return value;
}

using Rgb = std::array<std::uint8_t, 3>;

struct Image {
    std::uint32_t width = 0, height = 0;
    std::vector<Rgb> pixels;

    std::size_t colours() const { return std::set<Rgb>(pixels.begin(), pixels.end()).size(); }
    template <class Test>
    auto count(Test test) const {
        return std::count_if(pixels.begin(), pixels.end(), test);
    }
};

/// A PNG of 8-bit RGB. Inflated by the zlib that VTK has loaded, so that the tests link nothing for it.
inline Image decode(const std::string& png) {
    REQUIRE(png.substr(1, 3) == "PNG");
    Image image{big_endian(png, 16), big_endian(png, 20), {}};
    std::string packed;
    for (std::size_t at = 8; at + 12 <= png.size(); at += 12 + big_endian(png, at))
        if (png.substr(at + 4, 4) == "IDAT") packed += png.substr(at + 8, big_endian(png, at));
    using Uncompress = int (*)(unsigned char*, unsigned long*, const unsigned char*, unsigned long);
    const auto uncompress = reinterpret_cast<Uncompress>(::dlsym(::dlopen("libz.so.1", RTLD_NOW), "uncompress"));
    REQUIRE(uncompress);
    const std::size_t row = 3 * image.width;
    std::vector<std::uint8_t> raw((row + 1) * image.height);
    unsigned long size = raw.size();
    REQUIRE(uncompress(raw.data(), &size, reinterpret_cast<const unsigned char*>(packed.data()), packed.size()) == 0);
    REQUIRE(size == raw.size());

    std::vector<std::uint8_t> above(row, 0), line(row);
    for (std::size_t y = 0; y < image.height; ++y) {
        const std::uint8_t* in = raw.data() + y * (row + 1);
        const int filter = *in++;
        for (std::size_t x = 0; x < row; ++x) {
            const int a = x >= 3 ? line[x - 3] : 0, b = above[x], c = x >= 3 ? above[x - 3] : 0, p = a + b - c;
            const int pa = std::abs(p - a), pb = std::abs(p - b), pc = std::abs(p - c);
            const int paeth = pa <= pb && pa <= pc ? a : pb <= pc ? b : c;
            const int guesses[5] = {0, a, b, (a + b) / 2, paeth};
            line[x] = static_cast<std::uint8_t>(in[x] + guesses[filter]);
        }
        for (std::size_t x = 0; x < row; x += 3) image.pixels.push_back({line[x], line[x + 1], line[x + 2]});
        above = line;
    }
    return image;
}

/// The picture of a snapshot.
inline Image picture(const Snapshot& snapshot, const View& view) {
    const Folder folder;
    REQUIRE(render(folder / "a.png", snapshot, view) == "");
    return decode(contents(folder / "a.png"));
}

inline bool is_red(Rgb c) { return c[0] > 120 && c[1] < 60 && c[2] < 60; }

}  // namespace hinge::output::test
