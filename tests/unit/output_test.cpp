// The output module, loaded as the program loads it: frames on disk, pictures, and what it says when it cannot.

#include "output_parts.h"

using namespace hinge::output;
using namespace hinge::output::test;

TEST_CASE("a snapshot comes back as it was written") {
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
    SECTION("laws that are not eq 14") {
        snapshot.laws = {"eq 14", "exact, hardening"};
        for (Bar& bar : snapshot.bars)
            for (int k = 0; k < 3; ++k)
                if (bar.element % 2 == 0) bar.yield_along[k] = 0.25 * k + 0.125 * bar.element;
    }

    REQUIRE(write(folder / "a.vtp", portal(2)) == "");  // an older one
    REQUIRE(write(folder / "a.vtp", snapshot) == "");
    Snapshot back;
    back.groups = {"left over"};
    REQUIRE(read(folder / "a.vtp", back) == "");
    check_same(snapshot, back);
    CHECK(back.factor == snapshot.factor);
    CHECK(back.laws == snapshot.laws);
    for (std::size_t i = 0; i < snapshot.bars.size(); ++i)
        for (int k = 0; k < 3; ++k) CHECK(back.bars[i].yield_along[k] == snapshot.bars[i].yield_along[k]);
    // frames of eq 14 alone are what they were
    CHECK((contents(folder / "a.vtp").find("f_y along") != std::string::npos) == !snapshot.laws.empty());
    CHECK(folder.files() == 1);  // nothing is left beside it
}

TEST_CASE("the collection lists times and files") {
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

TEST_CASE("what cannot be written or read is said, with what to do") {
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

TEST_CASE("a damaged frame is refused") {
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

TEST_CASE("a message is cut to the room there is") {
    char error[8] = "xxxxxxx";
    const auto call = load<hinge_write_snapshot>("hinge_write_snapshot");
    CHECK(call("/nowhere/a.vtp", portal(1), error, 5) == hinge::output::not_written);
    CHECK(std::string(error) == "No s");  // such file or directory
    CHECK(call("/nowhere/a.vtp", portal(1), nullptr, 0) == hinge::output::not_written);
}
