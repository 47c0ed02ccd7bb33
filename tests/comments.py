# SPDX-License-Identifier: GPL-3.0-or-later
"""Every module, type, component and procedure of src/ and drivers/ has a comment: a line `!>` stands before it.

So has every argument of an interface, and of a public procedure that another folder uses or that is for other programs, but `self`,
which its type describes. What is said elsewhere is not said again: a procedure whose comment begins with "See `x_t`" has the
arguments of the interface of that type, and one of C ("See adfric.h") those of the header.
Within a folder an argument has a comment where its name, its type and its unit do not say what it is, which no test can judge.
A function of C in an interface needs none, since it stands where the C code has it; its arguments do.
"""

import re
import tempfile
import unittest
from pathlib import Path

ROOT = Path(__file__).resolve().parents[1]
MODULE = re.compile(r"^(?:module|program)\s+(?!procedure\b)(\w+)$", re.IGNORECASE)
TYPE = re.compile(r"^type\s*(?:,[^'\"]*?)?(?:::|\s)\s*(\w+)$", re.IGNORECASE)
# What may stand before the word, the name, and the arguments.
PROCEDURE = re.compile(r"^(?!end\b)(?:[\w()=,.%* ]*\s)?(?:subroutine|function)\s+(\w+)\s*(?:\(([^()]*)\))?", re.IGNORECASE)
DECLARATION = re.compile(r"^[^!'\"]*?::\s*(.*)$")
USE = re.compile(r"^use\b[^'\"]*?\b(adfric\w*)\s*(?:,\s*only\s*:\s*(.*))?$", re.IGNORECASE)
BINDING = re.compile(r"^procedure\b[^'\"]*?(?:::)\s*(.*)$", re.IGNORECASE)
# What the comment of a procedure begins with whose arguments are described elsewhere.
ELSEWHERE = re.compile(r"^See (?:`(\w+_t)`|adfric\.h)")
# Folders whose procedures are for other programs, where they are public.
FOR_OTHERS = ("api", "c", "contact")
PUBLIC = re.compile(r"^public\s*::\s*(.*)$", re.IGNORECASE)


def statements_of(text):
    """Each statement with the number of its first line and the line before it, without comments and continuations."""
    lines = [line.strip() for line in text.splitlines()]
    place = 0
    while place < len(lines):
        first, statement = place, lines[place]
        place += 1
        if not statement or statement.startswith(("!", "#")):
            continue
        while statement.endswith("&") and place < len(lines):
            if not lines[place].startswith("!"):
                statement = f"{statement[:-1].rstrip()} {lines[place].lstrip('&').lstrip()}"
            place += 1
        yield first + 1, statement, lines[first - 1] if first else ""


def names_of(declared):
    """The names behind `::`, in small letters, without dimensions and values."""
    while (shorter := re.sub(r"\([^()]*\)", "", declared)) != declared:
        declared = shorter
    return [part.split("=")[0].split("!")[0].strip().lower() for part in declared.split(",")]


def sources_of(root):
    """The files of the program."""
    return [path for folder in ("src", "drivers") for path in sorted((root / folder).rglob("*.f90*"))]


def shared_names(root):
    """The names that a module gives to other folders, by module."""
    statements = {path: [statement for _, statement, _ in statements_of(path.read_text())] for path in sources_of(root)}
    folder_of = {module[1]: path.parent for path, lines in statements.items() for line in lines if (module := MODULE.match(line))}
    shared = {module: set() for module in folder_of}
    for path, lines in statements.items():
        for use in filter(None, map(USE.match, lines)):
            if folder_of.get(use[1], path.parent) != path.parent:
                shared[use[1]] |= {name.split("=>")[-1].strip().lower() for name in (use[2] or "").split(",")}
    return shared


def procedures_of_types(text, types):
    """The procedures of a module that are bound to some of its types."""
    bound, open_type = set(), ""
    for _, statement, _ in statements_of(text):
        if kind := TYPE.match(statement):
            open_type = kind[1].lower()
        elif re.match(r"end\s*type\b", statement, re.IGNORECASE):
            open_type = ""
        elif open_type in types and (binding := BINDING.match(statement)):
            bound |= {name.split("=>")[-1].strip().lower() for name in binding[1].split(",")}
    return bound


def public_names(text):
    """What a module says is public."""
    return {name for _, statement, _ in statements_of(text) if (public := PUBLIC.match(statement)) for name in names_of(public[1])}


def comment_above(lines, number):
    """The comment `!>` that stands before a line, as one text."""
    first = number - 1
    while first and lines[first - 1].strip().startswith("!>"):
        first -= 1
    return " ".join(line.strip()[2:].strip() for line in lines[first:number - 1])


def things_of(text, shared=None):
    """What needs a comment: the number of its line, the line before it, and what it is.

    `shared` has the procedures whose arguments need one; None: all do.
    """
    lines = text.splitlines()
    open_type, procedure, arguments, is_inside, is_elsewhere = "", "", set(), False, False
    for number, statement, before in statements_of(text):
        if module := MODULE.match(statement):
            yield number, before, f"module {module[1]}"
        elif head := PROCEDURE.match(statement):
            for name in sorted(arguments):
                yield number, "", f"argument {name} of {procedure}, whose declaration is not found"
            is_elsewhere = bool(ELSEWHERE.match(comment_above(lines, number)))
            procedure, arguments = head[1], {name.strip().lower() for name in (head[2] or "").split(",")} - {""}
            if not re.search(r"\bbind\s*\(\s*c\s*,\s*name\b", statement, re.IGNORECASE):
                yield number, before, f"procedure {procedure}"
        elif kind := TYPE.match(statement):
            open_type = kind[1]
            yield number, before, f"type {open_type}"
        elif re.match(r"(?:contains|end\s*type)\b", statement, re.IGNORECASE):
            is_inside = is_inside or not open_type
            open_type = ""
        elif declaration := DECLARATION.match(statement):
            names = names_of(declaration[1])
            if open_type:
                yield number, before, f"component {', '.join(names)} of {open_type}"
            elif found := [name for name in names if name in arguments]:
                arguments.difference_update(found)
                if is_inside and (is_elsewhere or shared is not None and (procedure.lower() not in shared or found == ["self"])):
                    continue
                yield number, before, f"argument {', '.join(found)} of {procedure}"


def types_pointed_at(text):
    """The types that comments point at for the arguments of a procedure, with the numbers of their lines."""
    for number, line in enumerate(text.splitlines(), 1):
        if line.strip().startswith("!>") and (elsewhere := ELSEWHERE.match(line.strip()[2:].strip())) and elsewhere[1]:
            yield number, elsewhere[1]


def faults_of(root):
    """Everything without its comment, as FILE:LINE: what it is."""
    shared, faults = shared_names(root), []
    types = {kind[1] for path in sources_of(root) for _, statement, _ in statements_of(path.read_text())
             if (kind := TYPE.match(statement))}
    for path in sources_of(root):
        text = path.read_text()
        faults += [f"{path.relative_to(root).as_posix()}:{number}: there is no type {named}"
                   for number, named in types_pointed_at(text) if named not in types]
        names = set().union(*(shared[module] for module in re.findall(r"^module (adfric\w*)$", text, re.MULTILINE)))
        if path.parent.name in FOR_OTHERS:
            names |= public_names(text)
        needed = names | procedures_of_types(text, names)
        faults += [f"{path.relative_to(root).as_posix()}:{number}: no comment `!>` before {what}"
                   for number, before, what in things_of(text, needed) if not before.startswith("!>")]
    return faults


class Comments(unittest.TestCase):
    """The sources as they are, and sources without comments."""

    def test_sources(self):
        """Everything has its comment."""
        faults = faults_of(ROOT)
        self.assertEqual([], faults, "\n" + "\n".join(faults))

    def check(self, text, *expected, use="use adfric_base_a, only: f, g, s, t"):
        """What a source has without a comment, where another folder uses names of it."""
        with tempfile.TemporaryDirectory() as folder:
            file, other = Path(folder, "src", "base", "a.f90"), Path(folder, "src", "run", "b.f90")
            file.parent.mkdir(parents=True)
            other.parent.mkdir(parents=True)
            file.write_text(text)
            other.write_text(f"!> B.\nmodule adfric_run_b\n   {use}\nend module adfric_run_b\n")
            faults = [fault.split(":", 1)[1] for fault in faults_of(Path(folder))]
        self.assertEqual([f"{number}: no comment `!>` before {what}" for number, what in expected], faults)

    def test_right(self):
        """Comments everywhere; variables, bindings and statements need none."""
        self.check("!> A.\nmodule adfric_base_a\n   integer, parameter :: one = 1\n   !> T.\n   type, extends(b_t) :: t\n      private\n"
                   "      !> C.\n      real :: c(2) = [1, 2]\n   contains\n      procedure :: f => g\n   end type t\n"
                   "   interface\n      subroutine c_h(x) bind(c, name='h')\n         !> X.\n         real, value :: x\n"
                   "      end subroutine c_h\n   end interface\ncontains\n   !> F.\n   pure real function g(self, &\n"
                   "      & x) result(y)\n      !> S.\n      class(t), intent(in) :: self\n      !> X, and of what shape.\n"
                   "      real, intent(in) :: &\n         x(:)\n      real :: y\n      y = sum(x)\n   end function g\nend module adfric_base_a\n")

    def test_wrong(self):
        """Each kind of thing without its comment, and a comment that is none of this kind."""
        self.check("module adfric_base_a\n   type t\n      real :: c, d\n   end type t\ncontains\n   ! F\n"
                   "   elemental real(dp) function f(x, y) result(z)\n      real, intent(in) :: x, y\n      real :: z\n"
                   "      z = x\n   end function f\n   !> S.\n   subroutine s(a)\n      !> Of b.\n      real :: b\n"
                   "      real, intent(in) :: A(size(b))\n   end subroutine s\nend module adfric_base_a\n",
                   (1, "module adfric_base_a"), (2, "type t"), (3, "component c, d of t"), (7, "procedure f"),
                   (8, "argument x, y of f"), (16, "argument a of s"))

    def test_own_folder(self):
        """Arguments of what no other folder uses need no comment, those of a type that one uses do."""
        text = ("!> A.\nmodule adfric_base_a\n   !> T.\n   type :: t\n   contains\n      procedure :: f => g\n   end type t\ncontains\n"
                "   !> G.\n   real function g(x)\n      real, intent(in) :: x\n   end function g\n"
                "   !> H.\n   real function h(y)\n      real, intent(in) :: y\n   end function h\nend module adfric_base_a\n")
        self.check(text, use="implicit none")
        self.check(text, (11, "argument x of g"), use="use adfric_base_a, only: t")
        self.check(text, (15, "argument y of h"), use="use :: adfric_base_a, only: own => h")

    def test_said_elsewhere(self):
        """Arguments that a type describes, or the header of C, need no comment; a type that is not there describes none."""
        text = ("!> A.\nmodule adfric_base_a\n   !> T.\n   type :: t_t\n   end type t_t\ncontains\n   !> See `t_t`:\n   !> more.\n"
                "   subroutine f(x)\n      real, intent(in) :: x\n   end subroutine f\n   !> See adfric.h.\n"
                "   subroutine g(x)\n      real, intent(in) :: x\n   end subroutine g\nend module adfric_base_a\n")
        self.check(text)
        self.check(text.replace("See `", "As `"), (10, "argument x of f"))
        with tempfile.TemporaryDirectory() as folder:
            file = Path(folder, "src", "base", "a.f90")
            file.parent.mkdir(parents=True)
            file.write_text(text.replace("See `t_t`", "See `other_t`"))
            self.assertEqual(["src/base/a.f90:7: there is no type other_t"], faults_of(Path(folder)))

    def test_interfaces(self):
        """Arguments of bindings and of abstract interfaces count, procedures that are arguments, too."""
        self.check("!> A.\nmodule adfric_base_a\n   interface\n      function c_f(x) bind(c, name='f')\n         real, value :: x\n"
                   "      end function c_f\n   end interface\n   abstract interface\n      subroutine s_i(g)\n"
                   "         procedure(h_i) :: g\n      end subroutine s_i\n   end interface\nend module adfric_base_a\n",
                   (5, "argument x of c_f"), (9, "procedure s_i"), (10, "argument g of s_i"))


if __name__ == "__main__":
    unittest.main()
