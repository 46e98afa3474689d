// What a run reports of itself beside its state. Most of it only one kind of run has; the others have nothing there.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "algebra/effective_stiffness.h"

namespace hinge {

class Dynamics;
class Statics;
struct Fastest;
struct Instability;
struct LostBalance;

class RunReport {
public:
    virtual ~RunReport() = default;

    virtual const char* kind() const = 0;  ///< "static" or "dynamic"
    virtual bool is_static() const = 0;
    virtual EffectiveStiffness::Counts solver_counts() const = 0;
    virtual long rejected() const = 0;         ///< steps taken back by step control; in statics tries that were halved
    virtual long substeps() const = 0;         ///< equilibria found; in dynamics the steps
    virtual double part_done() const = 0;      ///< of the way to the end: 0 to 1
    virtual std::string way_done() const = 0;  ///< "at 0.29 of its load", "at t = 0.12 s, after 41 of 100 steps"

    // statics
    virtual const Statics* statics() const { return nullptr; }  ///< for what only statics has, such as its control
    virtual bool limit() const { return false; }                ///< it has ended at a limit load
    virtual bool short_of_target() const { return false; }      ///< control by arc length ended before its load factor
    virtual const Instability* instability() const { return nullptr; }         ///< the first one found
    virtual std::string instability_text() const { return {}; }                ///< where, how many, by what motion
    virtual const std::vector<std::uint8_t>* held() const { return nullptr; }  ///< by supports and by the run
    virtual void on_each_try(std::function<void()>) {}  ///< called before each try of a step that may be halved

    // dynamics
    virtual const LostBalance* lost() const { return nullptr; }      ///< of an energy balance that no longer closed
    virtual double largest_energy() const { return 0; }              ///< J, that any account has had where it looked
    virtual const Fastest* fastest_node() const { return nullptr; }  ///< so far
    virtual std::optional<double> shortest_controlled() const { return {}; }  ///< s, of steps under step control
    virtual const Dynamics* dynamics() const { return nullptr; }  ///< for what only dynamics has, such as checkpoints
    virtual Dynamics* dynamics() { return nullptr; }
};

}  // namespace hinge
