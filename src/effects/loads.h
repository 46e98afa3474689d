// Loads on nodes, as a script declares them.
#pragma once

#include <functional>

#include "model/model.h"

namespace hinge {

inline constexpr const char* loads_effect = "loads";

/// Force and moment at a node.
struct NodalLoad {
    int node;
    Vec3 force = Vec3::Zero(), moment = Vec3::Zero();  ///< N, N m, in space
    History history = {};
    int number = 0;  ///< unique in the model, rising
    /// Functions of time (s) that replace force or moment: the value at the end of a step for the state at its start;
    /// dynamics only.
    std::function<Vec3(double)> force_rule = {}, moment_rule = {};
    bool follows_state() const { return force_rule || moment_rule; }
    int load_case = -1;
    bool held = false;  ///< statics: acts in full from the start (Model::choose)
    void times(double factor);
    void forget_history() { history = {}; }
    template <class Self, class A>
    static void fields(Self& s, A& a) {
        a(s.node, s.force, s.moment, s.history, bool(s.force_rule), bool(s.moment_rule));
    }
};

int add_load(Model& model, NodalLoad load);                  ///< returns its number
const NodalLoad* find_load(const Model& model, int number);  ///< null once it is removed
void remove_load(Model& model, int number);

}  // namespace hinge
