// A checkpoint: a dynamic run as the bytes of a file, to go on from with the same bits.
//
// The file: eight bytes that say what it is, CRC-32 of all that follows, the format's number, which hinge wrote it, how
// long the rest is; then step and time, the fingerprint of the model, what whoever drives the run keeps beside it, and
// the run. All little endian.
#pragma once

#include <string_view>

#include "run/fingerprint.h"

namespace hinge {

/// To be raised whenever a list of fields changes.
inline constexpr std::uint32_t checkpoint_format = 39;

/// What a checkpoint says before the run itself.
struct Checkpoint {
    long step = 0;
    double time = 0;    ///< s
    bool over = false;  ///< of a run that has no step left
    std::vector<FingerprintPart> model;
    std::string beside;
    std::string_view run = {};  ///< within the bytes that were opened
    template <class Self, class A>
    static void fields(Self& s, A& a) {
        a(s.step, s.time, s.over, s.model, s.beside);
    }
};

/// The bytes of a checkpoint of the run as it is. Changes nothing in it.
std::string checkpoint_of(const Dynamics& run, std::string beside = {});

/// Whether a file that begins with these bytes is one, of any format.
bool begins_checkpoint(std::string_view bytes);

/// Looks into the bytes of the file `path`, which must outlive the result. Throws OutsideError where they are not a
/// whole checkpoint that this hinge can read, naming what happened and what to do.
Checkpoint open_checkpoint(std::string_view bytes, const std::string& path);

/// The run goes on from there. Throws InputError, naming the parts, where the checkpoint is of another model or other
/// settings, and OutsideError where its contents are not valid; the run is then as it was.
void resume(Dynamics& run, const Checkpoint& from, const std::string& path);

/// A run that began with the state of `before`, with its velocities, of the same model and settings but for the
/// duration, goes on as that one would have, to the bit. Does nothing where something else has changed, or where
/// `before` failed.
void go_on(Dynamics& run, const Dynamics& before);

}  // namespace hinge
