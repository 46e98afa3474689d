#include "advice/size_notice.h"

#include <sys/resource.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <fstream>
#include <limits>

#include "algebra/factor_size.h"
#include "core/errors.h"
#include "core/text.h"

namespace hinge {
namespace {

constexpr std::size_t large = 20000;         ///< members
constexpr std::size_t many = 100000;         ///< members: a line while they are declared
constexpr double of_element = 8e3;           ///< bytes, of a run, at most (measured: 1.4e3 explicit, 7e3 static)
constexpr double operations_a_second = 7e8;  ///< of a factorisation, on one core of a common machine
constexpr double long_time = 20;             ///< s, of a factorisation

/// 201720 as "201,720"
std::string grouped(std::size_t n) {
    std::string text = std::to_string(n);
    for (int at = int(text.size()) - 3; at > 0; at -= 3) text.insert(std::size_t(at), ",");
    return text;
}

std::string bytes_text(double bytes) {
    char text[40];
    if (bytes < 1e9) std::snprintf(text, sizeof text, "%.0f MB", bytes / 1e6);
    else std::snprintf(text, sizeof text, bytes < 1e11 ? "%.1f GB" : "%.0f GB", bytes / 1e9);
    return text;
}

/// The number after a name in a file such as /proc/meminfo; infinite where there is none.
double number_after(const char* file, const std::string& name) {
    std::ifstream lines(file);
    std::string word;
    double value = 0;
    while (lines >> word)
        if (word == name) return lines >> value ? value : std::numeric_limits<double>::infinity();
    return std::numeric_limits<double>::infinity();
}

/// The number in a file, infinite where there is none.
double number_in(const char* file) {
    std::ifstream lines(file);
    double value = 0;
    return lines >> value ? value : std::numeric_limits<double>::infinity();
}

/// Bytes that the process may still take: what the machine, the limits of the process and its group leave.
double memory_left() {
    double left = std::min(1024 * number_after("/proc/meminfo", "MemAvailable:"),
                           number_in("/sys/fs/cgroup/memory.max") - number_in("/sys/fs/cgroup/memory.current"));
    if (std::isnan(left)) left = 1024 * number_after("/proc/meminfo", "MemAvailable:");
    for (const auto& [limit, used] : {std::pair{RLIMIT_AS, "VmSize:"}, std::pair{RLIMIT_DATA, "VmData:"}}) {
        rlimit room = {};
        if (::getrlimit(limit, &room) == 0 && room.rlim_cur != RLIM_INFINITY)
            left = std::min(left, double(room.rlim_cur) - 1024 * number_after("/proc/self/status", used));
    }
    return left;
}

}  // namespace

std::string members_notice(std::size_t members) {
    const std::size_t times = members / many;
    if (members < many || members % many != 0 || (times & (times - 1)) != 0) return "";
    return "a large model: " + grouped(members) + " members so far";
}

std::string size_notice(const Model& model) {
    const std::size_t members = model.members().size();
    if (members < large) return "";
    std::size_t elements = 0;
    for (const MemberData& m : model.members()) elements += std::size_t(m.elements);
    const std::size_t nodes = model.nodes().size() + elements - members;
    return "a large model: " + grouped(members) + " members, " + grouped(elements) + " elements, " + grouped(nodes) +
           " nodes, at most " + grouped(6 * nodes) + " degrees of freedom";
}

std::string static_notice(const Structure& structure, int steps) {
    const std::size_t elements = structure.elements().size();
    if (elements < 2000) return "";
    std::vector<std::pair<int, int>> pairs;
    pairs.reserve(elements);
    for (const Element& e : structure.elements()) pairs.emplace_back(e.node[0], e.node[1]);
    const FactorSize size = factor_size(int(structure.position().size()), pairs);
    const double bytes = size.bytes + of_element * double(elements), left = memory_left(),
                 time = size.operations / operations_a_second;
    const std::string what = "factorises the stiffness of " + grouped(std::size_t(structure.free_dofs())) +
                             " degrees of freedom: about " + bytes_text(bytes) + " of memory";
    if (bytes > left)
        throw InputError("model:static: a run of it " + what + ", and " + bytes_text(std::max(0.0, left)) +
                         " are left; make the model smaller (fewer members, elements_per_member), or give it more "
                         "memory");
    if (structure.model().members().size() < large && time < long_time && bytes < 0.5 * left) return "";
    return "a static run of it " + what + " (" + bytes_text(left) + " are left) and about " +
           duration_text(std::max(1.0, time)) + " of time, at least " + std::to_string(steps + 1) + " times";
}

std::string dynamic_notice(const Structure& structure) {
    if (structure.model().members().size() < large) return "";
    const double bytes = of_element * double(structure.elements().size()), left = memory_left();
    return "a dynamic run of it takes about " + bytes_text(bytes) + " of memory; " + bytes_text(left) + " are left" +
           (bytes > left ? ": that is too little, and the system may end the program" : "");
}

}  // namespace hinge
