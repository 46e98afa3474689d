// What the process that draws for a script in the sandbox is asked for, as bytes: numbers and texts, no code.
#pragma once

#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "output/picture.h"

namespace hinge {

/// A file to be drawn or written.
struct DrawingOrder {
    enum class What : int { picture, strip, frame, collection, plot } what = What::picture;
    std::string path{};
    std::vector<output::Snapshot> snapshots{};
    std::vector<output::View> views{};                     ///< of a picture one, of a strip as many as snapshots
    int columns = 0;                                       ///< of a strip
    std::vector<std::pair<double, std::string>> frames{};  ///< of a collection: time, s, and file
    std::string plot{};                                    ///< as hinge.plot.data packs it
};

std::string to_bytes(const DrawingOrder& order);
DrawingOrder order_from_bytes(std::string_view bytes);  ///< throws Damaged

}  // namespace hinge
