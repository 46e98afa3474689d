// Contents of a picture, without a picture library: the interface of the output module.
//
// Only the files behind this header use VTK. They form a separate module (libhinge_output.so), loaded for the first
// picture or ParaView frame, so that a run without pictures starts in milliseconds. Line plots are drawn by
// gnuplot (script/bind/bind_plot.cpp).
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace hinge::output {

/// What functions of the module return where a file could not be written; the message is then why alone.
inline constexpr int not_written = 2;

enum class BarState : std::uint8_t { elastic = 0, yielded = 1, broken = 2 };

/// The shape of a cross-section, for drawing; y along the member's `up`, x across.
struct Shape {
    enum Kind : std::uint8_t { rectangle = 0, h = 1, round = 2 };
    Kind kind = rectangle;
    double width = 0, depth = 0;  ///< m, along x and y
    double web = 0, flange = 0;   ///< m, of an H
    bool operator==(const Shape&) const = default;
};

/// One element as drawn: a straight bar. A broken element runs from its node to a virtual node (paper, section 2.3).
struct Bar {
    int point[2];  ///< indices into Snapshot::points
    double yield;  ///< f_y of the section's law, 0 to 1 (larger of the two ends)
    BarState state;
    int group;     ///< index into Snapshot::groups: the member's first group; -1 if it has none
    int member;    ///< declared member, counted from 1
    int element;   ///< element, counted from 1
    double width;  ///< contact width of the member, m
    double N = 0;  ///< N, tension positive; 0 in a broken one, as all forces
    double Mx[2] = {0, 0}, My[2] = {0, 0}, Mz = 0;  ///< N m, at its first and its second end
    double Qx[2] = {0, 0}, Qy[2] = {0, 0};          ///< N; dMx/dz = Qy, dMy/dz = -Qx on the chord
    /// P L^2 / EI about x and y, P positive in compression: the axial force acts on the bow of the bar between its ends
    /// (BarBending::compression); 0: on its chord.
    double compression[2] = {0, 0};
    double N0 = 0, Mx0 = 0, My0 = 0, Mz0 = 0;  ///< fully plastic resultants, N and N m; 0 without limit
    std::uint8_t hinges = 0;        ///< sections that were ever fully plastic: 1 first end, 2 second end, 4 middle
    std::uint8_t touched = 0;       ///< 1: it has been in contact
    double rotation[2] = {0, 0};    ///< plastic rotation of its hinges about x and y together, rad, not negative
    std::array<double, 3> up = {};  ///< direction of the section's y axis now, of unit length; zero: not known
    int shape = -1;                 ///< index into Snapshot::shapes; -1: a square of its width
    int node[2] = {-1, -1};         ///< its declared end points, also of a broken end; -1: not known
    /// f_y at its first end, in its middle and at its second end by a law that is not eq 14; negative: eq 14, which
    /// follows from the forces.
    double yield_along[3] = {-1, -1, -1};
};

/// A load that acts at this instant.
struct Load {
    enum Kind : std::uint8_t { force = 0, moment = 1 };
    Kind kind = force;
    int point = -1;                             ///< acts on this point, or:
    int bar = -1;                               ///< on this bar,
    double at = -1;                             ///< at this share of its length; -1: spread over it
    std::array<double, 3> value[2] = {{}, {}};  ///< N or N m, in space; spread: N/m or N m/m where it begins and ends
    double from = 0, to = 1;                    ///< spread: the part of the bar that it covers
    bool is_partial() const { return from > 0 || to < 1; }
};

/// A panel of a floor. One that has forces is drawn in the colour of the larger of them.
struct Panel {
    std::vector<int> points;   ///< at its corners, in their order
    bool has_forces = false;   ///< it is a plate (model:panel); else its members carry it
    double force[2] = {0, 0};  ///< principal membrane forces, N/m, tension positive, the larger one first
    bool torn = false;
    double membrane[3] = {0, 0, 0};  ///< n11, n22, n12 in the sheet's axes, N/m
    double used = 0;                 ///< largest part of its ultimate strain that a layer has reached
};

/// A plane that members fall on; the solid is on the side that `normal` points away from.
struct Plane {
    std::array<double, 3> point, normal;
};

/// A structure at one instant.
struct Snapshot {
    double time = 0;                            ///< s
    std::optional<double> factor;               ///< load factor, of statics, which have no time
    std::vector<std::array<double, 3>> points;  ///< m
    std::vector<std::uint8_t> is_virtual;  ///< per point: 1 for the virtual node of a broken element; empty: none is
    std::vector<std::array<double, 3>> displacement;  ///< m, per point, of an end of a broken element too; or empty
    std::vector<std::array<double, 3>> rotation;      ///< per point: rotation vector since the start, rad; or empty
    std::vector<std::uint8_t> held;                   ///< per point: bits 0 to 5, ux to rz; or empty
    int declared = 0;  ///< points that the script has declared as nodes; they come first, and number i is point i - 1
    std::vector<Bar> bars;
    std::vector<Shape> shapes;
    std::vector<Load> loads;
    std::vector<Load> weights;  ///< not drawn, but diagrams have them: weights along members that are not even
    std::vector<Panel> floors;
    std::vector<Plane> ground;
    std::vector<std::string> groups;
    std::vector<std::array<int, 2>> memberships;  ///< a member, from 1, and one of its groups, from 0
    std::vector<std::array<int, 2>> connected;    ///< points that connectors join, as declared
    std::vector<std::string> laws;                ///< of its sections; empty if all have eq 14 alone
    bool joints = false;                          ///< dots may show joints, too: there are some that can yield
};

/// Quantity shown on the members: by their colour, or as a diagram along them.
enum class Show : std::uint8_t { yield, group, broken_in, nothing, N, Qx, Qy, Mx, My, Mz };

/// Settings of a picture; every field has a default that shows the whole structure in six colours of f_y.
struct View {
    int width = 1600, height = 1200;                  ///< pixels
    std::array<double, 3> from = {-1.0, -1.4, 0.55};  ///< direction from the middle of the scene to the eye
    std::array<double, 3> up = {0, 0, 1};
    bool parallel = false;  ///< without perspective
    double scale = 1;       ///< factor of drawn displacements; 0: chosen so that they can be seen
    Show show = Show::yield;
    int runs = 0;                ///< with Show::broken_in: how many runs are counted,
    std::vector<int> broken_in;  ///< and in how many of them each member broke, by its number less 1; else 0
    double largest = 0;          ///< value that a diagram draws in full size, N or N m; 0: the largest value
    bool ghost = false;          ///< the shape at the start, behind
    bool supports = true, ground = true, hinges = true, floors = true;
    bool loads = false;
    bool node_labels = false, member_labels = false;
    bool leave_out_broken = false;           ///< as in fig 18 of the paper
    double above = -1e300;                   ///< draw only bars with both ends above this height, m
    std::optional<std::vector<int>> groups;  ///< draw only members of these, indices into Snapshot::groups; else all
    std::array<std::optional<double>, 3> plane;  ///< draw only bars that start in this plane: x, y or z, m
    std::string title;
    /// xmin, xmax, ymin, ymax, zmin, zmax in m that the picture shows. Empty: fitted to this snapshot without its stray
    /// fragments. A film needs one box for all its frames, or the camera moves.
    std::optional<std::array<double, 6>> box;
};

}  // namespace hinge::output

// The module's functions, found by name with dlsym. Each returns 0, or 1 with a message in `error` (at most `room`
// bytes). They may be called from any thread; they take turns.
extern "C" {
/// Writes `snapshot` as binary VTP: points, lines, and arrays named after the fields of Snapshot and Bar; aside, then
/// renamed.
using hinge_write_snapshot = int (*)(const char* path, const hinge::output::Snapshot& snapshot, char* error, int room);
/// Writes the ParaView collection of n frames (times in s, file names relative to the collection).
using hinge_write_collection = int (*)(const char* path, int n, const double* times, const char* const* files,
                                       char* error, int room);
/// Reads a VTP written by hinge_write_snapshot.
using hinge_read_snapshot = int (*)(const char* path, hinge::output::Snapshot& snapshot, char* error, int room);
/// Draws `snapshot` into a PNG; works without a display when Xvfb is installed, else says in one line how to get it.
using hinge_render = int (*)(const char* path, const hinge::output::Snapshot& snapshot, const hinge::output::View& view,
                             char* error, int room);
/// Draws n snapshots side by side into one PNG, `columns` in a row, each of the first view's size.
using hinge_render_strip = int (*)(const char* path, int n, const hinge::output::Snapshot* const* snapshots,
                                   const hinge::output::View* views, int columns, char* error, int room);
}
