"""Pages of Moon and other tactile scripts: their surface, the force that a tip feels there, their
letters and pictures. Calls libmoontrace.so.0 by ctypes; needs no compiler.

    import moontrace
    page = moontrace.page("the moon", letter_size=0.012)
    page.letters[0]                      # Letter(sign='th', x=0.015, ...)
    page.sample(0.02, 0.27)              # displacement [m], its slopes along x and y
    heights = page.height_map(0.0002)    # an array, row 0 at the page's foot
    forces = page.forces(path)           # of an array with x, y, z in each row [m]; newtons
    page.draw("page.svg")
    mug = moontrace.Object(page, "cylinder", (0.04, 0.05))
    mug.force(0.0, -0.0395, 0.0)         # of a tip on its front; moontrace_shape says the frame

Units are SI: metres and newtons. The origin is the page's lower left corner, x goes along the text,
y up the page, z out of the paper; z = 0 is the flat paper. Arrays need NumPy, all else does not.
Any thread may use any object at any time. What the library refuses is raised as moontrace.Error.
"""

import collections
import ctypes
import glob
import os

try:
    import numpy
except ImportError:  # one point at a time works without
    numpy = None

__all__ = ["Error", "Letter", "Object", "Page", "Script", "Text", "page", "version"]


class Error(Exception):
    """A call that was refused. `code` is one of BAD_CALL, BAD_INPUT, LACKING, FAULT."""

    def __init__(self, code, message):
        super().__init__(message)
        self.code = code


FAULT, BAD_CALL, BAD_INPUT, LACKING = 1, 2, 3, 4

Letter = collections.namedtuple("Letter", "sign x y line word source_begin source_end")

_INTERFACE = 2
_U32, _SIZE, _STEP = ctypes.c_uint32, ctypes.c_size_t, ctypes.c_ssize_t
_DOUBLE, _TEXT, _HANDLE = ctypes.c_double, ctypes.c_char_p, ctypes.c_void_p


def _struct(name, *fields):
    """A struct of moontrace.h, made with its own size in the first field."""

    def init(self, **values):
        for unknown in sorted(set(values) - {field for field, _ in fields[1:]}):
            raise TypeError("no such setting: " + unknown)
        ctypes.Structure.__init__(self, size=ctypes.sizeof(self), **values)

    fields = [("size", _U32)] + [(field, kind) for kind, names in fields for field in names.split()]
    return type(name, (ctypes.Structure,), {"_fields_": fields, "__init__": init})


def _arrays(names):
    return [part for name in names.split() for part in ((_HANDLE, name), (_STEP, name + "_step"))]


_Style = _struct(
    "_Style", (_U32, "embossed rules raised_margin structure reserved"), (_TEXT, "sheet"),
    (_DOUBLE, "margin letter_size width depth rounding letter_gap word_gap line_pitch grade"),
    (_TEXT, "h_form table only lines links hyphenation"))
_ScriptFacts = _struct("_ScriptFacts", (_U32, "reserved"), (_TEXT, "name title author licence"),
                       (_SIZE, "signs"), (_DOUBLE, "letter_size"))
_TextFacts = _struct("_TextFacts", (_U32, "reserved"), (_SIZE, "pages letters folded missing"),
                     (_DOUBLE, "letter_size width depth line_pitch"))
_PageFacts = _struct("_PageFacts", (_U32, "reserved"), (_DOUBLE, "width height"),
                     (_SIZE, "letters lines"),
                     (_DOUBLE, "greatest_fall greatest_rise greatest_slope"))
_LetterFacts = _struct("_LetterFacts", (_U32, "reserved"), (_TEXT, "sign"), (_DOUBLE, "x y"),
                       (_SIZE, "line word source_begin source_end"))
_Surface = _struct("_Surface", (_U32, "law"), (_DOUBLE, "stiffness force_cap"))
_Samples = _struct("_Samples", (_U32, "reserved"), (_SIZE, "count"),
                   *_arrays("x y displacement gradient_x gradient_y"))
_Forces = _struct("_Forces", (_U32, "reserved"), (_SIZE, "count"),
                  *_arrays("x y z force_x force_y force_z"))
_Shape = _struct("_Shape", (_U32, "corner"), (_TEXT, "kind face"), (_DOUBLE * 3, "half"),
                 (_DOUBLE, "u v turn"))
_ObjectFacts = _struct("_ObjectFacts", (_U32, "reserved"), (_TEXT, "face"), (
    _DOUBLE, "text_width text_height least_scale greatest_scale greatest_depth"))
_ObjectSamples = _struct("_ObjectSamples", (_U32, "reserved"), (_SIZE, "count"), *_arrays(
    "x y z displacement gradient_x gradient_y gradient_z height"))


def _load():
    """The library that $MOONTRACE_LIBRARY names, else the one installed with this file, else the
    system's."""
    named = os.environ.get("MOONTRACE_LIBRARY")
    if named:
        return ctypes.CDLL(named)
    lib = os.path.dirname(os.path.dirname(os.path.dirname(os.path.abspath(__file__))))
    beside = glob.glob(lib + "/libmoontrace.so.0") + glob.glob(lib + "/*/libmoontrace.so.0")
    return ctypes.CDLL(beside[0] if beside else "libmoontrace.so.0")


_library = _load()
for _name, _kinds in {
        "check": (_U32,), "version": (), "message": (),
        "script_open": (_TEXT, _TEXT, _HANDLE), "script_describe": (_HANDLE, _HANDLE),
        "script_close": (_HANDLE,), "text_open": (_HANDLE, _TEXT, _HANDLE, _HANDLE),
        "text_describe": (_HANDLE, _HANDLE), "text_close": (_HANDLE,),
        "page_open": (_HANDLE, _SIZE, _HANDLE), "page_describe": (_HANDLE, _HANDLE),
        "page_letter": (_HANDLE, _SIZE, _HANDLE), "page_draw": (_HANDLE, _TEXT, _U32),
        "page_close": (_HANDLE,), "sample": (_HANDLE, _DOUBLE, _DOUBLE, _HANDLE),
        "sample_many": (_HANDLE, _HANDLE),
        "force": (_HANDLE, _HANDLE, _DOUBLE, _DOUBLE, _DOUBLE, _HANDLE),
        "force_many": (_HANDLE, _HANDLE, _HANDLE),
        "object_open": (_HANDLE, _HANDLE, _HANDLE), "object_describe": (_HANDLE, _HANDLE),
        "object_place": (_HANDLE, _DOUBLE, _DOUBLE, _DOUBLE, _HANDLE),
        "object_sample": (_HANDLE, _DOUBLE, _DOUBLE, _DOUBLE, _HANDLE),
        "object_sample_many": (_HANDLE, _HANDLE),
        "object_force": (_HANDLE, _HANDLE, _DOUBLE, _DOUBLE, _DOUBLE, _HANDLE),
        "object_force_many": (_HANDLE, _HANDLE, _HANDLE), "object_close": (_HANDLE,)}.items():
    _function = getattr(_library, "moontrace_" + _name)
    _function.argtypes = _kinds
    _function.restype = _TEXT if _name in ("version", "message") else ctypes.c_int


def _require(answer):
    if answer != 0:
        raise Error(answer, _library.moontrace_message().decode("utf-8", "replace"))


_require(_library.moontrace_check(_INTERFACE))
_Three, _Five = _DOUBLE * 3, _DOUBLE * 5


def version():
    """The version of the program that the library belongs to."""
    return _library.moontrace_version().decode()


def _facts(describe, handle, kind):
    facts = kind()
    _require(describe(handle, ctypes.byref(facts)))
    return facts


class _Open:
    """A handle that is closed with its object."""

    def __init__(self, close, open_, *values):
        handle = _HANDLE()
        _require(open_(*values, ctypes.byref(handle)))
        self._handle, self._close = handle, close

    def __del__(self):
        if getattr(self, "_handle", None):
            self._close(self._handle)


class Script(_Open):
    """A script by name or by the path of its file."""

    def __init__(self, name="moon"):
        super().__init__(_library.moontrace_script_close, _library.moontrace_script_open,
                         os.fsencode(name), None)
        facts = _facts(_library.moontrace_script_describe, self._handle, _ScriptFacts)
        self.name, self.title = facts.name.decode(), facts.title.decode()
        self.author, self.licence = facts.author.decode(), facts.licence.decode()
        self.signs, self.letter_size = facts.signs, facts.letter_size


class Text(_Open):
    """A text that is set on pages. `style` takes the fields of moontrace_style by name, such as
    letter_size=0.02, sheet="a5", embossed=True, links="letters"."""

    def __init__(self, script, words, **style):
        given = _Style(**{name: value.encode() if isinstance(value, str) else value
                          for name, value in style.items()})
        words = words.encode()
        if b"\0" in words:
            raise Error(BAD_INPUT, "the text holds a character 0")
        super().__init__(_library.moontrace_text_close, _library.moontrace_text_open,
                         script._handle, words, ctypes.byref(given))
        facts = _facts(_library.moontrace_text_describe, self._handle, _TextFacts)
        self.pages, self.folded, self.missing = facts.pages, facts.folded, facts.missing
        self.letter_size, self.width, self.depth = facts.letter_size, facts.width, facts.depth


class Page(_Open):
    """One page of a text, counted from 0, as a surface."""

    def __init__(self, text, number=0):
        super().__init__(_library.moontrace_page_close, _library.moontrace_page_open,
                         text._handle, number)
        facts = _facts(_library.moontrace_page_describe, self._handle, _PageFacts)
        self.width, self.height = facts.width, facts.height
        self.greatest_fall, self.greatest_rise = facts.greatest_fall, facts.greatest_rise
        self.letters = [self._letter(number) for number in range(facts.letters)]

    def _letter(self, number):
        letter = _LetterFacts()
        _require(_library.moontrace_page_letter(self._handle, number, ctypes.byref(letter)))
        return Letter(letter.sign.decode(), letter.x, letter.y, letter.line, letter.word,
                      letter.source_begin, letter.source_end)

    def sample(self, x, y):
        """Displacement of the paper at a point [m], below zero in grooves, and its slopes along x
        and y."""
        three = _Three()
        _require(_library.moontrace_sample(self._handle, x, y, three))
        return tuple(three)

    def samples(self, points, out=None):
        """The same for an array whose rows are points: three numbers in each row of `out`, or of a
        new array. Nothing is copied where the numbers are of 64 bits."""
        points = _rows(points, 2)
        out = _room(out, len(points))
        x, y = (_column(points, i) for i in range(2))
        many = _Samples(count=len(points), **_named("x", x), **_named("y", y),
                        **_named("displacement", _column(out, 0)),
                        **_named("gradient_x", _column(out, 1)),
                        **_named("gradient_y", _column(out, 2)))
        _require(_library.moontrace_sample_many(self._handle, ctypes.byref(many)))
        return out

    def force(self, x, y, z, **surface):
        """The force on a tip at a point [N], zero outside the surface. `surface` takes stiffness
        [N/m], force_cap [N], and law: 0 (of a potential) or 1 (the paper's)."""
        three, given = _Three(), _Surface(**surface)
        _require(_library.moontrace_force(self._handle, ctypes.byref(given), x, y, z, three))
        return tuple(three)

    def forces(self, points, out=None, **surface):
        """The same for an array whose rows are x, y, z, such as a path: three forces in each row of
        `out`, or of a new array."""
        return _forces(_library.moontrace_force_many, self._handle, points, out, surface)

    def height_map(self, step):
        """Displacements of the whole page, `step` metres apart [m]: rows from its foot to its head,
        columns from left to right, each at the middle of its cell."""
        _need_numpy()
        if not step > 0:
            raise Error(BAD_CALL, "the step of a height map is above 0")
        columns = max(1, int(round(self.width / step)))
        rows = max(1, int(round(self.height / step)))
        x, y = (numpy.arange(columns) + 0.5) * step, (numpy.arange(rows) + 0.5) * step
        heights = numpy.empty((rows, columns))
        for row in range(rows):
            many = _Samples(count=columns, **_named("x", _column(x[:, None], 0)),
                            y=y.ctypes.data + row * y.itemsize, y_step=0,
                            **_named("displacement", _column(heights[row][:, None], 0)))
            _require(_library.moontrace_sample_many(self._handle, ctypes.byref(many)))
        return heights

    def draw(self, path, print_letters=False):
        """Draws the page in its true size, as .svg, .pdf or .png."""
        _require(_library.moontrace_page_draw(self._handle, os.fsencode(path), int(print_letters)))


class Object(_Open):
    """A page on a solid: "plane", "box", "cylinder", "sphere", "capsule" or "ellipsoid", of the sizes
    that moontrace_shape.half has [m]. `place` takes its other fields by name: face, u, v, turn,
    corner. Points are of the solid's frame."""

    def __init__(self, page, kind, half, **place):
        given = _Shape(kind=kind.encode(), half=_Three(*half),
                       **{name: value.encode() if isinstance(value, str) else value
                          for name, value in place.items()})
        super().__init__(_library.moontrace_object_close, _library.moontrace_object_open,
                         page._handle, ctypes.byref(given))
        facts = _facts(_library.moontrace_object_describe, self._handle, _ObjectFacts)
        self.face, self.greatest_depth = facts.face.decode(), facts.greatest_depth
        self.text_width, self.text_height = facts.text_width, facts.text_height
        self.least_scale, self.greatest_scale = facts.least_scale, facts.greatest_scale

    def place(self, x, y, z=0):
        """Where a place over the page, z above it, lies in the solid's frame [m]."""
        three = _Three()
        _require(_library.moontrace_object_place(self._handle, x, y, z, three))
        return tuple(three)

    def sample(self, x, y, z):
        """At a point: displacement along the smooth normal, its gradient in space (three numbers),
        and the point's height above the smooth surface."""
        five = _Five()
        _require(_library.moontrace_object_sample(self._handle, x, y, z, five))
        return tuple(five)

    def samples(self, points):
        """The same for an array whose rows are x, y, z: five numbers in each row."""
        points = _rows(points, 3)
        out = numpy.empty((len(points), 5))
        many = _ObjectSamples(count=len(points))
        _set_columns(many, points, "x y z")
        _set_columns(many, out, "displacement gradient_x gradient_y gradient_z height")
        _require(_library.moontrace_object_sample_many(self._handle, ctypes.byref(many)))
        return out

    def force(self, x, y, z, **surface):
        """The force on a tip at a point; `surface` as of Page.force."""
        three, given = _Three(), _Surface(**surface)
        _require(_library.moontrace_object_force(self._handle, ctypes.byref(given), x, y, z, three))
        return tuple(three)

    def forces(self, points, out=None, **surface):
        """The same for an array whose rows are x, y, z, as Page.forces."""
        return _forces(_library.moontrace_object_force_many, self._handle, points, out, surface)


def page(words, script="moon", **style):
    """The first page of a text."""
    return Page(Text(Script(script), words, **style))


def _need_numpy():
    if numpy is None:
        raise ImportError("arrays of points need NumPy: apt install python3-numpy")


def _rows(points, width):
    _need_numpy()
    points = numpy.asarray(points, dtype=numpy.float64)
    if points.ndim != 2 or points.shape[1] != width:
        raise Error(BAD_CALL, "points are rows of %d numbers, not an array of shape %s" %
                    (width, points.shape))
    return points


def _room(out, count):
    if out is None:
        return numpy.empty((count, 3))
    if out.dtype != numpy.float64 or out.shape != (count, 3) or not out.flags.writeable:
        raise Error(BAD_CALL, "out is a float64 array of shape (%d, 3) that can be written" % count)
    return out


def _column(array, number):
    return array.ctypes.data + number * array.strides[1], array.strides[0]


def _set_columns(many, array, names):
    for number, name in enumerate(names.split()):
        for part, value in _named(name, _column(array, number)).items():
            setattr(many, part, value)


def _forces(call, handle, points, out, surface):
    points = _rows(points, 3)
    out = _room(out, len(points))
    given, many = _Surface(**surface), _Forces(count=len(points))
    _set_columns(many, points, "x y z")
    _set_columns(many, out, "force_x force_y force_z")
    _require(call(handle, ctypes.byref(given), ctypes.byref(many)))
    return out


def _named(name, column):
    return {name: column[0], name + "_step": column[1]}
