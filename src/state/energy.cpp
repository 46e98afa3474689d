#include "state/energy.h"

#include <algorithm>
#include <mutex>
#include <set>

namespace hinge {

double& Accounts::operator[](std::string_view name) {
    for (auto& [known, sum] : sums_)
        if (known == name) return sum;
    return sums_.emplace_back(Sum{kept(name), 0}).value;
}

/// One text for each name ever used; runs of several threads may ask.
std::string_view Accounts::kept(std::string_view name) {
    static std::mutex guard;
    static std::set<std::string, std::less<>> names;
    const std::lock_guard lock(guard);
    const auto at = names.find(name);
    return at != names.end() ? *at : *names.emplace(name).first;
}

double Accounts::operator[](std::string_view name) const {
    for (const auto& [known, sum] : sums_)
        if (known == name) return sum;
    return 0;
}

double Energy::operator[](std::string_view name) const {
    return name == "initial" ? initial : name == "energy_error" ? error : accounts[name];
}

Energy balance(const AccountList& list, double initial, const Accounts& sums) {
    Energy e;
    e.initial = initial;
    for (const AccountInfo& info : list) e.accounts[info.name] = sums[info.name];
    for (const AccountInfo& info : list)
        if (!info.part_of.empty()) e.accounts[info.part_of] += sums[info.name];
    double held = 0;
    for (const AccountInfo& info : list)
        if (info.part_of.empty() && info.name != supplied_account) held += e.accounts[info.name];
    e.error = initial + e.accounts[supplied_account] - held;
    return e;
}

}  // namespace hinge
