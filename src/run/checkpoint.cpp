#include "run/checkpoint.h"

#include <zlib.h>

#include "core/archive.h"
#include "core/errors.h"

namespace hinge {
namespace {

constexpr std::string_view magic("hinge\r\n\x1a", 8);

/// What stands behind the magic bytes and the checksum, in every format.
struct Header {
    std::uint32_t format = checkpoint_format;
    char version[16] = HINGE_VERSION;
    std::uint64_t length = 0;  ///< of what follows, bytes
    template <class Self, class A>
    static void fields(Self& s, A& a) {
        a(s.format, s.version, s.length);
    }
};
constexpr std::size_t sum_at = magic.size(), header_at = sum_at + 4, rest_at = header_at + 28;

std::uint32_t sum_of(std::string_view bytes) {
    return std::uint32_t(crc32_z(0, reinterpret_cast<const Bytef*>(bytes.data()), bytes.size()));
}

void put(std::string& bytes, std::size_t at, const auto& value) {
    std::string text;
    Writer write(text);
    write(value);
    bytes.replace(at, text.size(), text);
}

}  // namespace

std::string checkpoint_of(const Dynamics& run, std::string beside) {
    std::string bytes(rest_at, '\0');
    Writer write(bytes);
    write(Checkpoint{run.state().step, run.state().time, run.verdict() != Verdict::running, fingerprint(run),
                     std::move(beside)});
    run.save(bytes);
    bytes.replace(0, magic.size(), magic);
    Header header;
    header.length = bytes.size() - rest_at;
    put(bytes, header_at, header);
    put(bytes, sum_at, sum_of(std::string_view(bytes).substr(header_at)));
    return bytes;
}

bool begins_checkpoint(std::string_view bytes) { return bytes.starts_with(magic); }

Checkpoint open_checkpoint(std::string_view bytes, const std::string& path) {
    const auto refuse = [&](const std::string& what) -> OutsideError {
        return OutsideError("checkpoint " + path + " " + what);
    };
    if (bytes.size() < magic.size() ? !magic.starts_with(bytes) : !bytes.starts_with(magic))
        throw refuse("is no checkpoint of hinge; is it the right file?");
    const char* const anew = "; go on from an older copy of it, or start the run anew";
    if (bytes.size() < rest_at) throw refuse("is cut short: " + std::to_string(bytes.size()) + " bytes" + anew);
    std::uint32_t sum = 0;
    Header header;
    Reader reader(bytes.substr(sum_at));
    reader(sum, header);
    const bool intact = sum_of(bytes.substr(header_at)) == sum;
    if (!intact && bytes.size() - rest_at < header.length)
        throw refuse("is cut short or damaged: " + std::to_string(bytes.size()) + " bytes of " +
                     std::to_string(rest_at + header.length) + anew);
    if (!intact || bytes.size() - rest_at != header.length)
        throw refuse(std::string("is damaged: its checksum does not fit") + anew);
    header.version[15] = '\0';
    if (header.format != checkpoint_format)
        throw refuse("is of format " + std::to_string(header.format) + ", written by hinge " + header.version +
                     "; this is hinge " + HINGE_VERSION + ", which reads format " + std::to_string(checkpoint_format) +
                     ": go on with the hinge that wrote it, or start the run anew");
    Checkpoint found;
    try {
        Reader rest(bytes.substr(rest_at));
        rest(found);
        found.run = rest.rest();
    } catch (const Damaged& e) { throw refuse(std::string("is damaged: ") + e.what() + anew); }
    return found;
}

void resume(Dynamics& run, const Checkpoint& from, const std::string& path) {
    if (const std::string other = difference(from.model, fingerprint(run)); !other.empty())
        throw InputError("checkpoint " + path + " is of another run, which differs in " + other +
                         "; give the script and parameters that it was written with, or start the run anew");
    try {
        run.restore(from.run);
    } catch (const Damaged& e) {
        throw OutsideError("checkpoint " + path + " is damaged: " + e.what() +
                           "; go on from an older copy of it, or start the run anew");
    }
}

void go_on(Dynamics& run, const Dynamics& before) {
    if (before.verdict() == Verdict::failed || run.verdict() != Verdict::running) return;
    std::vector<FingerprintPart> there = fingerprint(before), here = fingerprint(run);
    for (auto* parts : {&there, &here}) std::erase_if(*parts, [](const auto& p) { return p.name == "duration"; });
    if (difference(there, here).empty()) run.go_on_as(before);
}

}  // namespace hinge
