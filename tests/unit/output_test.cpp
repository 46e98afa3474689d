// The output module, loaded as the program loads it: frames on disk, pictures, plots, and what it says when it cannot.
#include <catch2/catch.hpp>

#include <dlfcn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <limits>
#include <set>
#include <string>
#include <vector>

#include "output/picture.h"
#include "output/plot.h"

using namespace hinge::output;
namespace fs = std::filesystem;

namespace {

template <class Function>
Function load(const char* name) {
    static void* module = ::dlopen(HINGE_OUTPUT_MODULE, RTLD_NOW | RTLD_LOCAL);
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

std::string write(const std::string& path, const Snapshot& snapshot) {
    return said([&](char* e, int room) {
        return load<hinge_write_snapshot>("hinge_write_snapshot")(path.c_str(), snapshot, e, room);
    });
}

std::string read(const std::string& path, Snapshot& snapshot) {
    return said([&](char* e, int room) {
        return load<hinge_read_snapshot>("hinge_read_snapshot")(path.c_str(), snapshot, e, room);
    });
}

std::string render(const std::string& path, const Snapshot& snapshot, const View& view) {
    return said(
        [&](char* e, int room) { return load<hinge_render>("hinge_render")(path.c_str(), snapshot, view, e, room); });
}

std::string plot(const std::string& path, const Plot& what, int width, int height) {
    return said(
        [&](char* e, int room) { return load<hinge_plot>("hinge_plot")(path.c_str(), what, width, height, e, room); });
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

std::string contents(const std::string& path) {
    std::ifstream file(path, std::ios::binary);
    return {std::istreambuf_iterator<char>(file), {}};
}

/// A portal frame of `bays` bays, f_y rising from 0 to 1 along it, its last beam broken.
Snapshot portal(int bays) {
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
        snapshot.held.push_back(i == 0 ? 63 : 0);
    }
    for (Bar& b : snapshot.bars) {
        const double k = b.element;  // numbers that a float holds
        b.N = -64 * k, b.Mx[0] = k, b.Mx[1] = 2 * k, b.My[0] = 3 * k, b.My[1] = 4 * k, b.Mz = 5 * k;
        b.N0 = 128 * k, b.Mx0 = 8 * k, b.My0 = 9 * k, b.Mz0 = 10 * k;
        b.hinges = std::uint8_t(b.element & 7), b.touched = std::uint8_t(b.element & 1);
        snapshot.memberships.push_back({b.member, b.group});
    }
    return snapshot;
}

void check_same(const Snapshot& a, const Snapshot& b) {
    CHECK(a.time == b.time);
    CHECK(a.points == b.points);
    CHECK(a.is_virtual == b.is_virtual);
    CHECK(a.groups == b.groups);
    CHECK(a.displacement == b.displacement);
    CHECK(a.held == b.held);
    CHECK(a.memberships == b.memberships);
    REQUIRE(a.bars.size() == b.bars.size());
    for (std::size_t i = 0; i < a.bars.size(); ++i) {
        const Bar &p = a.bars[i], &q = b.bars[i];
        CHECK(p.point[0] == q.point[0]);
        CHECK(p.point[1] == q.point[1]);
        CHECK(p.yield == q.yield);
        CHECK(p.state == q.state);
        CHECK(p.group == q.group);
        CHECK(p.member == q.member);
        CHECK(p.element == q.element);
        CHECK(p.width == q.width);
        CHECK(std::array{p.N, p.Mx[0], p.Mx[1], p.My[0], p.My[1], p.Mz} ==
              std::array{q.N, q.Mx[0], q.Mx[1], q.My[0], q.My[1], q.Mz});
        CHECK(std::array{p.N0, p.Mx0, p.My0, p.Mz0} == std::array{q.N0, q.Mx0, q.My0, q.Mz0});
        CHECK(int(p.hinges) == int(q.hinges));
        CHECK(int(p.touched) == int(q.touched));
    }
}

std::uint32_t big_endian(const std::string& bytes, std::size_t at) {
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
Image decode(const std::string& png) {
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

bool is_red(Rgb c) { return c[0] > 120 && c[1] < 60 && c[2] < 60; }

}  // namespace

TEST_CASE("a snapshot comes back as it was written", "[output]") {
    const Folder folder;
    Snapshot snapshot = portal(6);

    SECTION("as it is") {}
    SECTION("bars without a group, and no groups at all") {
        snapshot.groups.clear();
        for (Bar& bar : snapshot.bars) bar.group = -1;
    }
    SECTION("odd names of groups") { snapshot.groups = {"", "a b <&\">", "\xCF\x84\xCE\xB1"}; }
    SECTION("no bars") { snapshot = Snapshot{}; }
    SECTION("of statics") { snapshot.factor = 0.625; }

    REQUIRE(write(folder / "a.vtp", snapshot) == "");
    Snapshot back;
    back.groups = {"left over"};
    REQUIRE(read(folder / "a.vtp", back) == "");
    check_same(snapshot, back);
    CHECK(back.factor == snapshot.factor);
    CHECK(folder.files() == 1);  // nothing is left beside it
}

TEST_CASE("a frame replaces an older one", "[output]") {
    const Folder folder;
    REQUIRE(write(folder / "a.vtp", portal(2)) == "");
    REQUIRE(write(folder / "a.vtp", portal(3)) == "");
    Snapshot back;
    REQUIRE(read(folder / "a.vtp", back) == "");
    CHECK(back.bars.size() == portal(3).bars.size());
}

TEST_CASE("the collection lists times and files", "[output]") {
    const Folder folder;
    const double times[] = {0, 0.0025};
    const char* const files[] = {"frames/0.vtp", "a&b.vtp"};
    const auto call = load<hinge_write_collection>("hinge_write_collection");
    const std::string path = folder / "frames.pvd";
    REQUIRE(said([&](char* e, int room) { return call(path.c_str(), 2, times, files, e, room); }) == "");
    const std::string text = contents(path);
    CHECK_THAT(text, Catch::Contains("type=\"Collection\""));
    CHECK_THAT(text, Catch::Contains("timestep=\"0.0025\""));
    CHECK_THAT(text, Catch::Contains("file=\"a&amp;b.vtp\""));
}

TEST_CASE("what cannot be written or read is said, with what to do", "[output]") {
    const Folder folder;
    Snapshot snapshot = portal(1);
    CHECK_THAT(write(folder / "none/a.vtp", snapshot),
               Catch::Contains("No such file or directory") && Catch::Contains("make the folder"));
    fs::create_directory(folder / "taken");
    CHECK_THAT(write(folder / "taken", snapshot), Catch::Contains("folder of that name is in the way"));
    CHECK(folder.files() == 1);
    CHECK_THAT(write("", snapshot), Catch::Contains("file name"));

    CHECK_THAT(read(folder / "a.vtp", snapshot), Catch::Contains("cannot read"));
    std::ofstream(folder / "text.vtp") << "no frame at all";
    CHECK_THAT(read(folder / "text.vtp", snapshot), Catch::Contains("not a VTP file"));

    snapshot.bars[0].point[1] = 99;
    CHECK_THAT(write(folder / "a.vtp", snapshot), Catch::Contains("bar 0 ends at point 99"));
    CHECK_THAT(render(folder / "a.png", snapshot, {}), Catch::Contains("bar 0 ends at point 99"));
}

TEST_CASE("a damaged frame is refused", "[output]") {
    const Folder folder;
    REQUIRE(write(folder / "a.vtp", portal(6)) == "");
    const std::string whole = contents(folder / "a.vtp");
    for (const double share : {0.1, 0.5, 0.9}) {
        const auto size = static_cast<std::size_t>(share * static_cast<double>(whole.size()));
        std::ofstream(folder / "cut.vtp", std::ios::binary) << whole.substr(0, size);
        Snapshot back;
        CHECK_THAT(read(folder / "cut.vtp", back), Catch::Contains("cannot read"));
    }
}

TEST_CASE("a message is cut to the room there is", "[output]") {
    char error[8] = "xxxxxxx";
    const auto call = load<hinge_write_snapshot>("hinge_write_snapshot");
    CHECK(call("/nowhere/a.vtp", portal(1), error, 5) == 1);
    CHECK(std::string(error) == "cann");
    CHECK(call("/nowhere/a.vtp", portal(1), nullptr, 0) == 1);
}

TEST_CASE("a picture has the size asked for and shows the bars", "[output]") {
    const Folder folder;
    View view;
    view.width = 640;
    view.height = 480;
    view.title = "Portal";
    const Snapshot snapshot = portal(6);
    REQUIRE(render(folder / "a.png", snapshot, view) == "");
    const Image image = decode(contents(folder / "a.png"));
    CHECK(image.width == 640);
    CHECK(image.height == 480);
    CHECK(image.colours() > 200);
    CHECK(image.pixels.front() == Rgb{255, 255, 255});

    SECTION("the same bytes again") {
        REQUIRE(render(folder / "b.png", snapshot, view) == "");
        CHECK(contents(folder / "a.png") == contents(folder / "b.png"));
    }
    SECTION("hinges are red") {
        Snapshot yielded = snapshot;
        for (Bar& bar : yielded.bars) bar.yield = 1;
        REQUIRE(render(folder / "b.png", yielded, view) == "");
        CHECK(decode(contents(folder / "b.png")).count(is_red) > 3 * image.count(is_red) / 2);
    }
    SECTION("a view leaves bars out") {
        view.above = 1;
        REQUIRE(render(folder / "b.png", snapshot, view) == "");
        CHECK(contents(folder / "a.png") != contents(folder / "b.png"));
        view.above = -1;
        view.leave_out_broken = true;
        REQUIRE(render(folder / "c.png", snapshot, view) == "");
        CHECK(contents(folder / "a.png") != contents(folder / "c.png"));
    }
    SECTION("nothing to show is a picture too") {
        view.above = 100;
        CHECK(render(folder / "b.png", snapshot, view) == "");
    }
    SECTION("bars that went astray or are not numbers do no harm") {
        Snapshot wild = snapshot;
        wild.points[0] = {1e30, 0, 0};
        wild.points[1] = {std::numeric_limits<double>::quiet_NaN(), 0, 0};
        CHECK(render(folder / "b.png", wild, view) == "");
    }
}

TEST_CASE("a picture of statics shows the load factor, not a time", "[output]") {
    const Folder folder;
    Snapshot now = portal(2), later = now;
    later.time = 2 * now.time;
    const auto same = [&] {
        REQUIRE(render(folder / "now.png", now, {}) == "");
        REQUIRE(render(folder / "later.png", later, {}) == "");
        return contents(folder / "now.png") == contents(folder / "later.png");
    };
    CHECK(!same());
    now.factor = later.factor = 0.5;
    CHECK(same());
    later.factor = 0.75;
    CHECK(!same());
}

TEST_CASE("bars have the colour of their class: five of f_y, a hinge's, a broken one's", "[output]") {
    // The legend's colours (paper, fig 17), dark blue to orange, red for a hinge, black. A bar's pixels are those in
    // which the picture differs from one without it; light and shade change their brightness, hardly their hue.
    const Folder folder;
    View view;
    view.width = 320;
    view.height = 240;
    const std::array<double, 3> classes[] = {{54, 96, 176},  {82, 176, 214}, {92, 184, 112}, {240, 212, 72},
                                             {243, 146, 44}, {212, 24, 32},  {22, 22, 26}};
    const int hinge = 5, broken = 6;
    const auto drawn = [&](double yield, BarState state) {
        Snapshot snapshot;
        snapshot.points = {{0, 0, 0}, {1, 0, 0}};
        snapshot.is_virtual = {0, 0};
        snapshot.bars.push_back({{0, 1}, yield, state, -1, 1, 1, 0.3});
        REQUIRE(render(folder / "with.png", snapshot, view) == "");
        View nothing = view;
        const double ends[6] = {-0.3, 1.3, -0.3, 0.3, -0.3, 0.3};
        nothing.box.emplace();
        std::copy(ends, ends + 6, nothing.box->begin());
        snapshot.bars.clear();
        REQUIRE(render(folder / "without.png", snapshot, nothing) == "");
        return std::pair{decode(contents(folder / "with.png")), decode(contents(folder / "without.png"))};
    };
    const auto class_of = [&](double yield, BarState state) {
        const auto [with, without] = drawn(yield, state);
        std::array<double, 3> sum{};
        long n = 0;
        for (std::uint32_t y = with.height / 3; y < 2 * with.height / 3; ++y)  // beside title, axes and legend
            for (std::uint32_t x = with.width / 3; x < 2 * with.width / 3; ++x) {
                const Rgb c = with.pixels[y * with.width + x];
                if (c == without.pixels[y * with.width + x]) continue;
                ++n;
                for (int k = 0; k < 3; ++k) sum[k] += c[k];
            }
        REQUIRE(n > 500);
        const auto size = [](const std::array<double, 3>& c) { return std::hypot(c[0], c[1], c[2]); };
        if (size(sum) / double(n) < 60) return broken;
        int best = -1;
        double least = 1e9;
        for (int i = 0; i < broken; ++i) {
            double off = 0;
            for (int k = 0; k < 3; ++k) off += std::pow(sum[k] / size(sum) - classes[i][k] / size(classes[i]), 2);
            if (!(off >= least)) best = i, least = off;  // what is no number is no colour either
        }
        return best;
    };
    const struct {
        double yield;
        int colour;
    } elastic[] = {{0, 0},    {0.19, 0}, {0.21, 1}, {0.39, 1},  {0.41, 2},       {0.59, 2},   {0.61, 3},
                   {0.79, 3}, {0.81, 4}, {0.99, 4}, {0.998, 4}, {0.9995, hinge}, {1.0, hinge}};
    for (const auto& e : elastic) {
        INFO("f_y " << e.yield);
        CHECK(class_of(e.yield, BarState::elastic) == e.colour);
    }
    CHECK(class_of(0.3, BarState::yielded) == hinge);  // once a hinge, always one, whatever it bears now
    CHECK(class_of(0.3, BarState::broken) == broken);
    CHECK(class_of(1.0, BarState::broken) == broken);
}

TEST_CASE("a view that makes no sense is refused", "[output]") {
    const Folder folder;
    View view;
    SECTION("direction") {
        view.from = {0, 0, 0};
        CHECK_THAT(render(folder / "a.png", portal(1), view), Catch::Contains("view.from"));
    }
    SECTION("size") {
        view.width = 0;
        CHECK_THAT(render(folder / "a.png", portal(1), view), Catch::Contains("0 x 1200"));
    }
    CHECK(folder.files() == 0);
}

TEST_CASE("one stray fragment does not widen the frame", "[output]") {
    const Folder folder;
    Snapshot snapshot = portal(40);
    snapshot.points.back() = {5000, 0, 0};
    View view;
    view.width = 320;
    view.height = 240;
    REQUIRE(render(folder / "fitted.png", snapshot, view) == "");
    view.box = {0, 160, 0, 0, 0, 3};  // the portal without the fragment
    REQUIRE(render(folder / "boxed.png", snapshot, view) == "");
    CHECK(contents(folder / "fitted.png") == contents(folder / "boxed.png"));
    view.box = {0, 5000, 0, 0, 0, 3};
    REQUIRE(render(folder / "wide.png", snapshot, view) == "");
    CHECK(contents(folder / "fitted.png") != contents(folder / "wide.png"));
}

TEST_CASE("without any display the message says how to get one", "[output]") {
    const Folder folder;
    const auto call = load<hinge_render>("hinge_render");
    // In a child: the environment is its own, and so is the display it must look for anew.
    const pid_t child = ::fork();
    REQUIRE(child >= 0);
    if (child == 0) {
        ::unsetenv("DISPLAY");
        ::setenv("PATH", "/nowhere", 1);
        char error[512] = "";
        const int status = call((folder / "a.png").c_str(), portal(1), {}, error, sizeof error);
        const bool told = std::string(error).find("apt-get install xvfb") != std::string::npos;
        ::_exit(status == 1 && told ? 0 : 1);
    }
    int status = -1;
    REQUIRE(::waitpid(child, &status, 0) == child);
    CHECK(status == 0);
}

TEST_CASE("a plot has the size asked for and its curves", "[output]") {
    const Folder folder;
    Plot what;
    what.title = "Energy";
    what.panels.resize(1);
    Panel& panel = what.panels[0];
    panel.x_label = "t [s]";
    panel.y_label = "J";
    Series line{"kinetic", {}, {}, SeriesStyle::line, false}, dots{"measured", {}, {}, SeriesStyle::points, false};
    for (int i = 1; i <= 50; ++i) {
        line.x.push_back(0.01 * i);
        line.y.push_back(1e6 * std::exp(-0.1 * i));
    }
    dots.x = {0.1, 0.2};
    dots.y = {5e5, std::numeric_limits<double>::quiet_NaN()};
    panel.series = {line, dots};

    SECTION("linear") {}
    SECTION("logarithmic") { panel.log_x = panel.log_y = true; }
    SECTION("dashed") { panel.series[0].dashed = true; }
    SECTION("within a decade") {
        panel.log_y = true;
        for (double& y : panel.series[0].y) y = 6e5 + 0.1 * y;
    }
    REQUIRE(plot(folder / "a.png", what, 500, 400) == "");
    const Image image = decode(contents(folder / "a.png"));
    CHECK(image.width == 500);
    CHECK(image.height == 400);
    CHECK(image.colours() > 50);
    CHECK(image.count([](Rgb c) { return c == Rgb{213, 94, 0}; }) > 10);
    std::set<std::size_t> columns;  // the curve runs across the picture; in the legend it is short
    for (std::size_t i = 0; i < image.pixels.size(); ++i)
        if (image.pixels[i][2] > image.pixels[i][0] + 70) columns.insert(i % image.width);
    CHECK(columns.size() > 200);
}

TEST_CASE("a plot of nothing is refused", "[output]") {
    const Folder folder;
    Plot what;
    CHECK_THAT(plot(folder / "a.png", what, 500, 400), Catch::Contains("nothing to draw"));
    what.panels.resize(1);
    Panel& panel = what.panels[0];
    CHECK_THAT(plot(folder / "a.png", what, 500, 400), Catch::Contains("nothing to draw"));
    panel.series = {{"a", {1, 2}, {1}}};
    CHECK_THAT(plot(folder / "a.png", what, 500, 400), Catch::Contains("2 x and 1 y"));
    panel.series = {{"a", {1}, {-1}}};
    panel.log_y = true;
    CHECK_THAT(plot(folder / "a.png", what, 500, 400), Catch::Contains("positive on a logarithmic axis"));
}

TEST_CASE("bands and bars of a plot are as large as their values, cut at its ranges", "[output]") {
    const Folder folder;
    Plot what;
    what.panels.resize(1);
    Panel& panel = what.panels[0];
    const auto blue_pixels = [&] {
        REQUIRE(plot(folder / "a.png", what, 500, 400) == "");
        // blue, or blue through which the white shines
        return double(decode(contents(folder / "a.png")).count([](Rgb c) { return c[2] > c[0] + 30; }));
    };
    SECTION("bars") {
        panel.x_categories = {"one", "two"};
        panel.y_range = {0, 4};
        panel.series = {{"", {1}, {2}, SeriesStyle::bars}};
        const double two = blue_pixels();
        REQUIRE(two > 1000);
        panel.series = {{"", {1, 2}, {1, 3}, SeriesStyle::bars}};
        CHECK(blue_pixels() / two == Approx(2).epsilon(0.03));
        panel.series = {{"", {1, 2}, {4, 99}, SeriesStyle::bars}};
        CHECK(blue_pixels() / two == Approx(4).epsilon(0.03));
    }
    SECTION("bands") {
        panel.x_range = {0, 1};
        panel.y_range = {0, 4};
        panel.series = {{"", {0, 1}, {1, 1}, SeriesStyle::band, false, {2, 2}}};
        const double one = blue_pixels();
        REQUIRE(one > 1000);
        panel.series[0].high = {3, 5};  // cut at 4 on its second half: 3 - 0.25
        CHECK(blue_pixels() / one == Approx(2.75).epsilon(0.03));
        panel.series[0].x = {-1, 2};  // what is beside the range is cut too: from 3.67 to 4, and 4
        CHECK(blue_pixels() / one == Approx(3 - 1 / 12.0).epsilon(0.03));
    }
}
