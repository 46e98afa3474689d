// The output module, which is loaded when a picture or a frame is first asked for.
#pragma once

#include <dlfcn.h>

#include "core/files.h"
#include "output/picture.h"
#include "script/lua/context.h"

namespace hinge::script {

/// The picture module's function `name`, loaded with the module at first use.
template <class F>
F picture_function(const ScriptContext& c, const char* name) {
    static void* module = nullptr;
    if (!module) module = dlopen(c.picture_module.c_str(), RTLD_NOW | RTLD_LOCAL);
    if (!module)
        throw OutsideError(std::string("pictures need the module libhinge_output.so, which did not load (") +
                           dlerror() + "); build it with VTK installed: apt-get install libvtk9-dev");
    auto* f = reinterpret_cast<F>(dlsym(module, name));
    if (!f) throw OutsideError(std::string("the picture module has no function ") + name + "; rebuild it");
    return f;
}

/// Throws the message of a function of the module if it has failed. `path`: of the file that it writes.
inline void must_work(int status, const char* error, const std::string& path = "") {
    if (status == output::not_written) throw WriteError(path, error);
    if (status != 0) throw OutsideError(error);
}

}  // namespace hinge::script
