# Prints the commands of OpenSees that a script gives, for the small solver: one a line, words between characters 31.
# A second route beside hinge's own recorder: every name of the module is a command. Its
# value grows from call to call, so that loops up to a displacement end; that of analyze is 0.
#
# Run: python3 record.py FILE
import os
import sys
import types


calls = 0


class Commands(types.ModuleType):
    def __getattr__(self, name):
        if name.startswith("__"):
            raise AttributeError(name)

        def record(*args):
            words = [name]
            for value in args:
                words += list(map(str, value)) if isinstance(value, (list, tuple)) else [str(value)]
            print("\x1f".join(words).replace("\n", " "))
            global calls
            calls += 1
            return 0 if name == "analyze" else [1.0] * args[-1] if name == "eigen" else calls

        return record


# `from ... import *` gives what __all__ lists
Commands.__all__ = """beamIntegration element eleLoad equalDOF fiber fix fixX fixY fixZ geomTransf layer load loadConst mass
    model node patch pattern remove rigidDiaphragm rigidLink section sp timeSeries uniaxialMaterial wipe""".split()

module = Commands("openseespy.opensees")
package = types.ModuleType("openseespy")
package.opensees = module
sys.modules.update({"openseespy": package, "openseespy.opensees": module, "opensees": module})
path = os.path.abspath(sys.argv[1])
os.chdir(os.path.dirname(path))
sys.path.insert(0, os.path.dirname(path))
with open(path) as file:
    exec(compile(file.read(), path, "exec"), {"__name__": "__main__", "__file__": path})
