# Runs a script of OpenSeesPy and writes down the commands that it gives, for recorded.lua: the twin of recorder.tcl,
# which has the form of the records.
#
#   python3 -s -B recorder.py FILE TURN SECONDS COMMANDS RESULTS QUIET KNOWN
#
# The process is behind walls of the kernel (src/script/bind/bind_interpreters.cpp); nothing here keeps a script from
# anything. openseespy and the like are modules of this file. Modules that draw, and others that are not installed, are
# stand-ins whose values are not known.
import builtins
import io
import linecache
import os
import signal
import sys
import types
from importlib.machinery import ModuleSpec

main, turn, seconds = sys.argv[1], int(sys.argv[2]), float(sys.argv[3])
results, quiet, model = (set(names.split()) for names in sys.argv[5:8])
folder = os.path.dirname(main)
own = os.path.dirname(os.path.abspath(__file__))
records = os.fdopen(os.dup(1), "wb", buffering=0)
os.dup2(os.open(os.devnull, os.O_WRONLY), 1)
unknown = "\0"  # names.unknown of opensees_names.lua
needed = {"numpy": "python3-numpy", "scipy": "python3-scipy", "pandas": "python3-pandas"}
drawing = set(
    "IPython PIL cv2 imageio ipywidgets matplotlib meshio mpl_toolkits opensees_viewer openseesviewer opsvis ovito "
    "plotly pyvista seaborn tkinter tqdm trame vedo vfo vtk".split()
)


# ---- records ----------------------------------------------------------------------------------------------------


def put(*fields):
    text = "".join(str(field).replace("\x1e", " ").replace("\x1f", " ") + "\x1f" for field in fields)
    data = (text + "\x1e").encode("utf-8", "replace")
    while data:
        data = data[records.write(data) :]


def relative(path):
    if path == main:
        return ""
    inner = folder.rstrip("/") + "/"
    return path[len(inner) :] if path.startswith(inner) else path


def of_script(path):
    if path.startswith("<"):  # of Python itself
        return False
    path = os.path.join(folder, path)
    return path.startswith(folder.rstrip("/") + "/") and not path.startswith(own + "/")


# File, line and text of what the script runs now.
def where(frame=None):
    frame = frame or sys._getframe(1)
    while frame and not of_script(frame.f_code.co_filename):
        frame = frame.f_back
    if not frame:
        return "", 1, ""
    file, line = frame.f_code.co_filename, frame.f_lineno
    return relative(os.path.join(folder, file)), line, linecache.getline(file, line).strip()[:300]


def skip(*_, **__):
    put("s", *where())


# ---- values that are not known -----------------------------------------------------------------------------------


# A value of a module that is not there: what is made of it is not known either. It is false in one turn and true in the
# other, so that the records part where the script goes by it.
class Unknown:
    def __getattr__(self, name):
        if name.startswith("__"):
            raise AttributeError(name)
        return Unknown()

    def __call__(self, *_, **__):
        skip()
        return Unknown()

    # As many values as the script takes from it; a loop over it has no turn.
    def __iter__(self):
        frame = sys._getframe(1)
        code, at = frame.f_code.co_code, frame.f_lasti
        import dis

        if at >= 0 and dis.opname[code[at]] == "UNPACK_SEQUENCE":
            return iter([Unknown() for _ in range(code[at + 1])])
        return iter(())

    def __bool__(self):
        return turn == 1

    def __float__(self):
        return made_up()

    def __int__(self):
        return turn

    __index__ = __int__

    def __len__(self):
        return turn

    def __contains__(self, _):
        return turn == 1

    def __enter__(self):
        return Unknown()

    def __exit__(self, *_):
        return False

    def __hash__(self):
        return id(self)

    def __str__(self):
        return "unknown %d" % turn

    __repr__ = __str__

    def __format__(self, _):
        return str(self)

    def __setitem__(self, *_):
        pass

    def __delitem__(self, *_):
        pass


def unknown_of(*_, **__):
    return Unknown()


for _name in (
    "getitem add radd sub rsub mul rmul truediv rtruediv floordiv rfloordiv mod rmod pow rpow matmul rmatmul neg pos "
    "abs lt le gt ge eq ne and rand or ror xor rxor round"
).split():
    setattr(Unknown, "__%s__" % _name, unknown_of)


# ---- what a script may ask for -----------------------------------------------------------------------------------

state = {"steps": 0, "time": 0.0, "per_step": 1.0}
nodes, elements = {}, {}


# A result that is not known. It grows with the analyses, so that loops up to a displacement end; it is small in one
# turn and large in the other, so that what a script does beyond a limit differs.
def made_up(n=1):
    grown = min(state["steps"], 100)
    return (1.0e-3 * 1.31**grown if turn == 1 else 1.7e4 * 1.47**grown) * (1 + 0.1 * n)


def computed(name, args):
    first = args[0] if args else None
    if name == "analyze":
        count = first if isinstance(first, int) else 1
        state["steps"] += count
        state["time"] += count * (args[1] if len(args) > 1 and isinstance(args[1], float) else state["per_step"])
        return 0
    if name == "eigen":
        count = args[-1] if args and isinstance(args[-1], int) and 0 < args[-1] <= 10000 else 1
        return [made_up() * 1e5 * i * i for i in range(1, count + 1)]
    if name == "getTime":
        return state["time"]
    if name == "getNodeTags":
        return list(nodes)
    if name == "getEleTags":
        return list(elements)
    if name == "nodeCoord":
        return list(nodes[first]) if len(args) < 2 else nodes[first][args[1] - 1]
    if name == "eleNodes":
        return list(elements[first])
    if name in ("testIter", "numIter"):
        return turn
    if name in ("getPID", "getNP"):
        return int(name == "getNP")
    if name == "testNorm":
        return 0.0
    if name == "testNorms":
        return [0.0]
    if name not in results:
        return Unknown()
    if name.startswith(("ele", "basic", "section", "local")):
        return [made_up(i) for i in range(1, 13)]
    if len(args) > 1 or not name.startswith("node"):
        return made_up()
    return [made_up(i) for i in range(1, 7)]


# Keeps what nodeCoord and the like tell.
def keep(name, args):
    if name == "node" and args:
        at = []
        for x in args[1:]:
            if isinstance(x, str):
                break
            at.append(x)
        nodes[args[0]] = at
    elif name == "element" and len(args) > 3:
        elements[args[1]] = list(args[2:4])
    elif name == "remove" and len(args) > 1:
        {"node": nodes, "element": elements}.get(args[0], {}).pop(args[1], None)
    elif name == "wipe":
        nodes.clear()
        elements.clear()
        state.update(steps=0, time=0.0)
    elif name == "integrator":
        state["per_step"] = args[1] if len(args) > 1 and args[0] == "LoadControl" else made_up()
    elif name == "setTime" and args:
        state["time"] = args[0]
    elif name == "loadConst" and "-time" in args:
        state["time"] = args[args.index("-time") + 1]


# The arguments of a command one by one: numbers and texts.
def flat(values):
    for value in values:
        if isinstance(value, Unknown):
            yield value
        elif hasattr(value, "tolist"):  # of numpy: a number or a list
            yield from flat([value.tolist()])
        elif isinstance(value, (list, tuple, range, set, frozenset)) or hasattr(value, "__next__"):
            yield from flat(value)
        else:
            yield value


def text_of(value):
    if isinstance(value, Unknown):
        return unknown
    if isinstance(value, bool):
        return str(int(value))
    return repr(value) if isinstance(value, float) else str(value)


def command(name):
    def run(*values, **options):
        args = list(flat(values))
        for key, value in options.items():
            args += ["-" + key, *flat([value])]
        put("c", *where(), name, *(text_of(value) for value in args))
        keep(name, args)
        return None if name in model or name in quiet else computed(name, args)

    run.__name__ = name
    return run


# A model as an object, as xara and new versions have it.
class Model:
    def __init__(self, *values, **options):
        command("model")("basic", *values, **options)

    def __getattr__(self, name):
        return command(name)


# ---- modules -----------------------------------------------------------------------------------------------------


class Commands(types.ModuleType):
    def __getattr__(self, name):
        if name.startswith("__"):
            raise AttributeError(name)
        return Model if name == "Model" else command(name)


class StandIn(types.ModuleType):
    def __getattr__(self, name):
        if name == "__all__":  # import *: names that are not known may be its own
            names_of_main.open = True
            return []
        if name.startswith("__"):
            raise AttributeError(name)
        return Unknown()


# Names that main has neither itself nor from Python.
class Names(dict):
    open = False

    def __missing__(self, name):
        if self.open:
            return Unknown()
        raise KeyError(name)


names_of_main = Names(vars(builtins))
of_opensees = {"opensees", "openseespy", "openseespymac", "openseespywin", "openseespylinux", "xara"}
stand_ins = set()


# Whether the script imports, and not a module of Python, which has ways of its own where another module is missing.
def by_script():
    frame = sys._getframe(2)
    while frame and ("importlib" in frame.f_code.co_filename):
        frame = frame.f_back
    return frame is not None and of_script(frame.f_code.co_filename)


class Finder:
    def __init__(self, first):
        self.first = first

    def find_spec(self, name, path=None, target=None):
        top = name.partition(".")[0]
        if self.first:
            mine = top in of_opensees or top in drawing
        else:
            if top in needed and top == name:
                raise ModuleNotFoundError("%s is not installed: apt-get install %s" % (top, needed[top]), name=name)
            mine = top in stand_ins or top == name and by_script()
        return ModuleSpec(name, self, is_package=True) if mine else None

    def create_module(self, spec):
        name, _, last = spec.name.rpartition(".")
        top = spec.name.partition(".")[0]
        if top in of_opensees and last in ("opensees", "openseespy", top):
            module = Commands(spec.name)
            module.__all__ = sorted(results | quiet | model)
            return module
        if top not in stand_ins:
            stand_ins.add(top)
            place = where()
            if top in drawing or top in of_opensees:
                put("s", *place)
            else:
                put("u", *place, "the module %s is not there: what it does is not read" % top)
        return StandIn(spec.name)

    def exec_module(self, module):
        if isinstance(module, Commands) and module.__name__ in of_opensees - {"opensees", "xara"}:
            import importlib

            module.opensees = importlib.import_module(module.__name__ + ".opensees")


# ---- files: what would be written is kept in memory ----------------------------------------------------------------

written = {}
open_of_python = io.open


def kept(buffer, path):
    close = buffer.close

    def close_it():
        if not buffer.closed:
            written[path] = buffer.getvalue()
        close()

    buffer.close = close_it
    return buffer


class Text(io.StringIO):
    pass


class Bytes(io.BytesIO):
    pass


def open_file(file, mode="r", *args, **options):
    if isinstance(file, int):
        return open_of_python(file, mode, *args, **options)
    path = os.path.abspath(os.fspath(file))
    made = Bytes if "b" in mode else Text
    if set(mode) & set("wax+"):
        skip()
        buffer = made()
        if "a" in mode and isinstance(written.get(path), type(buffer.getvalue())):
            buffer.write(written[path])
        return kept(buffer, path)
    if path in written:
        text = written[path]
        if isinstance(text, bytes) != ("b" in mode):
            text = text.decode("utf-8", "replace") if isinstance(text, bytes) else text.encode()
        return made(text)
    return open_of_python(file, mode, *args, **options)


def replace_what_writes():
    builtins.open = io.open = names_of_main["open"] = open_file
    builtins.print = names_of_main["print"] = skip
    for name in "mkdir makedirs remove unlink rmdir removedirs rename replace".split():
        setattr(os, name, skip)
    import time

    time.sleep = lambda _: None


# ---- the script --------------------------------------------------------------------------------------------------


# Ends with a last record, whatever threads there are.
def finish(*fields):
    put(*fields)
    os._exit(0)


def too_long(_, frame):
    file, line, _ = where(frame)
    finish("l", file, line, "the script takes more than %g s; does a loop in it have no end?" % seconds)


# The line of the script that an error came from, the innermost one.
def place_of(error):
    if isinstance(error, SyntaxError) and error.filename and of_script(error.filename):
        return relative(os.path.join(folder, error.filename)), error.lineno or 1
    file, line, at = "", 1, error.__traceback__
    while at:
        name = at.tb_frame.f_code.co_filename
        if of_script(name):
            file, line = relative(os.path.join(folder, name)), at.tb_lineno
        at = at.tb_next
    return file, line


def run():
    sys.argv[:] = [main]
    sys.path[:] = [folder] + [path for path in sys.path if path and os.path.abspath(path) != own]
    sys.meta_path.insert(0, Finder(True))
    sys.meta_path.append(Finder(False))
    module = types.ModuleType("__main__")
    module.__file__ = main
    module.__builtins__ = names_of_main
    sys.modules["__main__"] = module
    with open_of_python(main, "rb") as file:
        text = file.read()
    replace_what_writes()
    signal.signal(signal.SIGALRM, too_long)
    signal.setitimer(signal.ITIMER_REAL, seconds)
    exec(compile(text, main, "exec", dont_inherit=True), module.__dict__)


try:
    run()
except SystemExit:
    pass
except BaseException as problem:  # KeyboardInterrupt and MemoryError, too
    finish("x", *place_of(problem), "%s: %s" % (type(problem).__name__, problem))
finish(".")
