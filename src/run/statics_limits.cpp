// What a static run says of where it came to a limit: by what motion the structure gives way, in which members, and
// what can go on past it.
#include <algorithm>
#include <cmath>
#include <map>

#include "core/text.h"
#include "run/statics.h"

namespace hinge {
namespace {

/// A structure that answers the load so many times as softly as it did at first is at a limit point.
constexpr double soft = 10;
constexpr std::size_t most_named = 3;

}  // namespace

/// By what motion the structure gives way, and in which members, where the tangent has just been factorised: those
/// that compression drives on as they bend or, where that is less than half of what drives the motion, those that all
/// their forces drive on.
void Statics::describe_mode() {
    Instability& found = *instability_;
    const std::vector<Vec6> mode = effective_->negative_mode();
    double most = 0;
    for (std::size_t i = 0; i < mode.size(); ++i)
        for (int c = 0; c < 6; ++c)
            if (const double size = std::abs(mode[i][c]) * (c < 3 ? 1 : mean_length_); size > most)
                most = size, found.node = int(i), found.component = c;
    if (found.node < 0 && pressed_ >= 0) {
        found.members.assign(1, pressed_);
        return;
    }
    std::map<int, double> by_compression, by_all_forces;
    double of_compression = 0, of_all_forces = 0;
    for (std::size_t i = 0; i < structure_->elements().size(); ++i) {
        if (state_.broken[i]) continue;
        const Element& e = structure_->elements()[i];
        const auto place = [&](int n) -> Vec3 { return structure_->position()[n] + w_.trial.displacement[n]; };
        const Vec3 along = (place(e.node[1]) - place(e.node[0])).normalized();
        Vec3 across = mode[e.node[1]].head<3>() - mode[e.node[0]].head<3>();
        across -= across.dot(along) * along;
        const double drive = -w_.force[i][4] / e.length * across.squaredNorm();
        by_compression[e.member] += drive;
        of_compression += std::max(drive, 0.0);
        Eigen::Matrix<double, 12, 1> ends;
        ends << mode[e.node[0]], mode[e.node[1]];
        const PlacedElement placed = place_element(*structure_, int(i), w_.trial);
        const double all = -ends.dot(element_tangent(placed, w_.force[i], Mat6::Zero(), true) * ends);
        by_all_forces[e.member] += all;
        of_all_forces += all;
    }
    found.by_compression = of_compression >= 0.5 * of_all_forces;
    std::vector<std::pair<double, int>> by_drive;
    for (const auto& [member, drive] : found.by_compression ? by_compression : by_all_forces)
        if (drive > 0) by_drive.emplace_back(-drive, member);
    std::sort(by_drive.begin(), by_drive.end());
    for (const auto& [drive, member] : by_drive)
        if (found.members.size() < 3 && drive <= 0.5 * by_drive[0].first) found.members.push_back(member);
}

const char* Statics::component_name(int component) {
    static const char* const name[] = {"ux", "uy", "uz", "rx", "ry", "rz"};
    return name[component];
}

std::string Statics::instability_text() const {
    if (!instability_) return {};
    const Instability& i = *instability_;
    const bool close = std::abs(i.beyond - i.factor) <= 1e-3 * std::abs(i.factor);
    std::string text = "the structure becomes unstable " +
                       (close ? "at load factor " + number_text(i.factor)
                              : "between load factors " + number_text(i.factor) + " and " + number_text(i.beyond)) +
                       (i.count > 1 ? ", in " + std::to_string(i.count) + " ways" : "");
    if (i.node >= 0) text += ": " + structure_->node_name(i.node) + " gives way, " + component_name(i.component);
    for (std::size_t k = 0; k < i.members.size(); ++k)
        text += (k > 0 ? (k + 1 == i.members.size() ? " and " : ", ")
                       : std::string(i.by_compression ? ", by compression of member" : ", by bending of member") +
                             (i.members.size() > 1 ? "s " : " ")) +
                std::to_string(i.members[k] + 1);
    if (i.node < 0 && !i.members.empty())
        text += ", beyond Euler's load between clamped ends: two elements cannot show that, four can";
    return text;
}

/// Where the last try was given up: the node that the loads move most, if that is far more than they did at first, and
/// the members with plastic hinges there. "" where the structure is as stiff as ever.
std::string Statics::limit_point() const {
    const double answers = softness();
    if (!(answers > soft * first_softness_) || !std::isfinite(answers)) return "";
    int node = 0, component = 0;
    double most = 0;
    for (std::size_t i = 0; i < response_.size(); ++i)
        for (int c = 0; c < 3; ++c)
            if (const double size = std::abs(response_[i][c]); size > most) most = size, node = int(i), component = c;
    std::vector<int> members;
    for (const Yielding& y : w_.yielding) members.push_back(structure_->elements()[y.element].member);
    std::sort(members.begin(), members.end());
    members.erase(std::unique(members.begin(), members.end()), members.end());
    std::string text =
        ": a limit load, where " + structure_->node_name(node) + " gives way, " + component_name(component);
    for (std::size_t i = 0; i < std::min(members.size(), most_named); ++i)
        text += (i > 0                 ? ", "
                 : members.size() == 1 ? ", with plastic hinges in member "
                                       : ", with plastic hinges in members ") +
                std::to_string(members[i] + 1);
    if (members.size() > most_named) text += " and " + std::to_string(members.size() - most_named) + " more";
    return text;
}

/// No equilibrium is found from where the state is: why that may be, and what can be done about it.
std::string Statics::advice_at_end() {
    if (settings_.control == Control::load) {
        const std::string where = limit_point(),
                          on = "; control by displacement or arc length goes on past it, to_limit = true takes it as "
                               "the end, and model:dynamic follows what comes after it in time";
        return where.empty() ? ": a limit load, a mechanism or a snap" + on : where + on;
    }
    if (settings_.control == Control::arc)
        return ": the path turns too sharply or ends there; more steps make a shorter arc";
    const int n = settings_.node, c = settings_.component;
    const std::string driven = std::string(component_name(c)) + " of " + structure_->node_name(n);
    w_.trial = pose_of(state_);
    recover();
    w_.yielding = hinges_;
    SolverSettings direct;
    direct.direct = true;
    if (renew_and_factorise(1)) {
        std::vector<Vec6> unit_load = w_.external;
        for (std::size_t i = 0; i < unit_load.size(); ++i)
            for (int k = 0; k < 6; ++k)
                if (held_[i] >> k & 1) unit_load[i][k] = 0;
        double most = 0;
        const bool solved = effective_->solve(unit_load, response_, direct).converged;
        const auto size = [&](std::size_t i, int k) { return std::abs(response_[i][k]) * (k < 3 ? 1 : mean_length_); };
        for (std::size_t i = 0; solved && i < response_.size(); ++i)
            for (int k = 0; k < 6; ++k) most = std::max(most, size(i, k));
        if (solved && size(n, c) <= 1e-9 * most)
            return ": the loads do not move " + driven + ", which is to be driven; drive what they move";
    }
    return ", where " + driven + " is " + number_text(displacement(n)[c]) + (c < 3 ? " m" : " rad") +
           ": it would have to turn back there, or the structure comes apart in another way; drive what goes on moving "
           "one way, or control by arc length";
}

}  // namespace hinge
