"""Prints the reference of a Python package as Markdown, from its sources: nothing is imported.

Usage: describe_python.py FOLDER PACKAGE
Every package with an __all__ is described, PACKAGE first, then those in it.
"""

import ast
import re
import sys
from pathlib import Path

FUNCTIONS = (ast.FunctionDef, ast.AsyncFunctionDef)


class Source:
    """A file of the package, and the names at its top."""

    def __init__(self, path):
        self.path = path
        self.tree = ast.parse(path.read_text("utf-8"), str(path))
        self.names = {}
        for node in self.tree.body:
            if isinstance(node, (*FUNCTIONS, ast.ClassDef)):
                self.names[node.name] = node
            elif isinstance(node, ast.AnnAssign) and isinstance(node.target, ast.Name):
                self.names[node.target.id] = node
            elif isinstance(node, ast.Assign):
                for target in node.targets:
                    if isinstance(target, ast.Name):
                        self.names[target.id] = node
            elif isinstance(node, ast.ImportFrom) and node.level > 0:
                for alias in node.names:
                    self.names[alias.asname or alias.name] = (node.level, node.module, alias.name)


class Package:
    def __init__(self, folder):
        self.folder = folder
        self.sources = {}

    def source(self, path):
        if path not in self.sources:
            self.sources[path] = Source(path)
        return self.sources[path]

    def module(self, name):
        base = self.folder.joinpath(*name.split("."))
        for path in (base / "__init__.py", base.with_suffix(".py"), base.with_suffix(".pyi")):
            if path.is_file():
                return self.source(path)
        sys.exit(f"There is no module {name} in {self.folder}.")

    def find(self, source, name):
        """Where a name is defined: `(source, node)`."""
        found = source.names.get(name)
        if found is None:
            sys.exit(f"{source.path}: {name} is in __all__, but is not defined there.")
        if not isinstance(found, tuple):
            return source, found
        level, module, original = found
        folder = source.path.parents[level - 1]
        inner = ".".join([*folder.relative_to(self.folder).parts, *([module] if module else [])])
        return self.find(self.module(inner), original)


def public_names(source):
    node = source.names.get("__all__")
    if node is None:
        sys.exit(f"{source.path} has no __all__, which says what is public.")
    return [name for name in ast.literal_eval(node.value) if not name.startswith("__")]


def doc_of(node):
    """Double backticks of reStructuredText are single ones in Markdown."""
    return (ast.get_docstring(node) or "").replace("``", "`")


def paragraph(text):
    return [f"{text}\n"] if text else []


def is_public(name):
    return not name.startswith("_") or name == "__len__"


def decorators(node):
    return [ast.unparse(each).split("(")[0].split(".")[-1] for each in node.decorator_list]


def signature(name, node, skip_self=False):
    """One argument a line, once there are several."""
    arguments = node.args
    if skip_self and arguments.args:
        arguments.args = arguments.args[1:]
    returns = f" -> {ast.unparse(node.returns)}" if node.returns else ""
    parts = [spaced(part) for part in split_arguments(ast.unparse(arguments))]
    line = f"{name}({', '.join(parts)}){returns}"
    if len(line) <= 80:
        return line
    return "\n".join([f"{name}(", *(f"    {part}," for part in parts), f"){returns}"])


def spaced(argument):
    """``x: int=1`` as it is usually written."""
    return re.sub(r"^(\w+: .*?)=", r"\1 = ", argument)


def split_arguments(text):
    if not text:
        return []
    parts, depth, last = [], 0, ""
    for letter in text:
        depth += letter in "([{"
        depth -= letter in ")]}"
        if letter == "," and depth == 0:
            parts.append(last.strip())
            last = ""
        else:
            last += letter
    return [*parts, last.strip()]


def aliases(node):
    """Other names for a member: ``height = width``."""
    for each in node.body:
        if isinstance(each, ast.Assign) and isinstance(each.value, ast.Name):
            for target in each.targets:
                yield target.id, each.value.id


def code(text):
    return f"```python\n{text}\n```\n"


def cell(text):
    return " ".join(text.split()).replace("|", "\\|")


def described_fields(node):
    """Rows of name, type and meaning: a field, and the text below it."""
    rows = []
    for field, after in zip(node.body, [*node.body[1:], None]):
        if not isinstance(field, ast.AnnAssign) or field.target.id.startswith("_"):
            continue
        text = ""
        if isinstance(after, ast.Expr) and isinstance(after.value, ast.Constant):
            text = str(after.value.value).replace("``", "`")
        rows.append((field.target.id, ast.unparse(field.annotation), text))
    for method in methods(node):
        if "property" in decorators(method):
            annotation = ast.unparse(method.returns) if method.returns else ""
            rows.append((method.name, annotation, doc_of(method)))
    return rows


def methods(node):
    return [each for each in node.body if isinstance(each, FUNCTIONS) and is_public(each.name)]


def inherited(package, source, node):
    """The classes of the package that a class extends, nearest last."""
    classes = []
    for base in node.bases:
        if isinstance(base, ast.Name) and base.id in source.names:
            where, found = package.find(source, base.id)
            if isinstance(found, ast.ClassDef):
                classes += [*inherited(package, where, found), found]
    return classes


def class_text(package, source, name, node):
    lines = [f"### {name}\n", *paragraph(doc_of(node))]
    family = [*inherited(package, source, node), node]
    made = [m for m in node.body if isinstance(m, FUNCTIONS) and m.name == "__init__"]
    if made:
        lines.append(code(signature(name, made[0], True)))
    rows = [row for each in family for row in described_fields(each)]
    if rows:
        lines.append("| Field | Type | Meaning |\n|---|---|---|")
        lines += [f"| `{field}` | `{cell(kind)}` | {cell(text)} |" for field, kind, text in rows]
        lines.append("")
    defaults = [each for member in family for each in default_fields(member)]
    if defaults:
        lines.append("| Field | Default |\n|---|---|")
        lines += [f"| `{field}` | `{value}` |" for field, value in defaults]
        lines.append("")
    for each in family:
        for method in methods(each):
            if "property" not in decorators(method):
                lines.append(code(signature(method.name, method, True)))
                lines += paragraph(doc_of(method))
    others = [f"`{other}` for `{member}`" for other, member in aliases(node)]
    if others:
        lines.append(f"Other names: {', '.join(others)}.\n")
    if any(isinstance(base, ast.Name) and base.id.endswith("Enum") for base in node.bases):
        values = [each for each in node.body if isinstance(each, ast.Assign)]
        names = [f"`{each.targets[0].id}` = {ast.unparse(each.value)}" for each in values]
        lines.append(f"{', '.join(names)}\n")
    return "\n".join(lines)


def default_fields(node):
    for each in node.body:
        is_table = isinstance(each, ast.Assign) and each.targets[0].id == "_defaults"
        if is_table:
            for key, value in zip(each.value.keys, each.value.values):
                yield key.value, ast.unparse(value)


def is_option_table(value):
    return isinstance(value, ast.Dict) and all(isinstance(each, ast.Call) for each in value.values)


def options_text(name, node):
    """A table of OptionInfo(name, default, range, text)."""
    lines = [f"### {name}\n", "| Option | Default | Range | Meaning |\n|---|---|---|---|"]
    for key, call in zip(node.value.keys, node.value.values):
        _, default, limits, text = (argument.value for argument in call.args)
        shown = default if isinstance(default, str) else repr(default)
        lines.append(f"| `{key.value}` | `{shown}` | {cell(limits)} | {cell(text)} |")
    return "\n".join([*lines, ""])


def text_of(package, source, name):
    where, node = package.find(source, name)
    if isinstance(node, FUNCTIONS):
        return "\n".join([f"### {name}\n", code(signature(name, node)), *paragraph(doc_of(node))])
    if isinstance(node, ast.ClassDef):
        return class_text(package, where, name, node)
    if is_option_table(node.value):
        return options_text(name, node)
    return "\n".join([f"### {name}\n", code(ast.unparse(node))])


def kind_of(package, source, name):
    _, node = package.find(source, name)
    return 0 if isinstance(node, FUNCTIONS) else 1 if isinstance(node, ast.ClassDef) else 2


def packages(folder, name):
    """The package and those in it, except for private ones."""
    for path in sorted(folder.joinpath(name).glob("**/__init__.py")):
        parts = path.relative_to(folder).parts[:-1]
        if not any(part.startswith("_") for part in parts):
            yield ".".join(parts)


def main(folder, name):
    package = Package(Path(folder))
    print("# Python reference\n")
    for module in packages(Path(folder), name):
        source = package.module(module)
        print(f"## {module}\n")
        print(f"{doc_of(source.tree)}\n")
        names = public_names(source)
        for each in sorted(names, key=lambda each: (kind_of(package, source, each), each)):
            print(text_of(package, source, each))


if len(sys.argv) != 3:
    sys.exit(__doc__.strip())
main(*sys.argv[1:])
