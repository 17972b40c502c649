"""Makes the site from the pages: `make.py MDBOOK REPORT ANIMATION FOLDER` writes FOLDER/book, and tests all links of what mdBook has built.

A page is where it is in the repository; SUMMARY.md lists the pages. Files to which they link come along.
"""

import re
import shutil
import subprocess
import sys
from html.parser import HTMLParser
from pathlib import Path
from urllib.parse import unquote, urlsplit

HERE = Path(__file__).parent
ROOT = HERE.parent
LINK = re.compile(r"(\]\()([^)\s]+)(\))")
CODE = re.compile(r"(```.*?```|`[^`\n]*`)", flags=re.S)


def pages() -> dict[str, Path]:
    """The pages of SUMMARY.md by their place in the site."""
    places = [place for _, place, _ in LINK.findall((HERE / "SUMMARY.md").read_text(encoding="utf-8"))]
    return {place: HERE / place if (HERE / place).is_file() else ROOT / place for place in places}


def is_outside(link: str) -> bool:
    return bool(urlsplit(link).scheme) or link.startswith("#")


def listing(folder: Path) -> str:
    """A page for a link to a folder: its pictures."""
    names = sorted(path.name for path in folder.iterdir() if path.suffix == ".png")
    pictures = "".join(f'<p>{name}<br><img src="{name}" alt="{name}" width="700"></p>\n' for name in names)
    return f'<!doctype html>\n<html lang="en"><meta charset="utf-8"><title>{folder.name}</title>\n{pictures}</html>\n'


def assemble(sources: Path, made: list[str]) -> list[str]:
    """Copies the pages and what they link to; returns the links that lead nowhere."""
    listed = pages()
    faults = []

    def moved(place: str, link: str) -> str:
        """The link of a page in the site, whose target is copied."""
        path, _, fragment = link.partition("#")
        folder = ROOT if listed[place].parent == HERE else listed[place].parent
        target = (folder / unquote(path)).resolve()
        name = target.relative_to(ROOT.resolve()).as_posix()
        copy = sources / name
        if path in made or name in listed:
            pass
        elif not target.exists() or target.suffix == ".md":
            faults.append(f"{place} links to {link}, which is {'not in SUMMARY.md' if target.exists() else 'not there'}")
        elif target.is_dir():
            shutil.copytree(target, copy, dirs_exist_ok=True, ignore=lambda _, names: [n for n in names if not n.endswith(".png")])
            (copy / "index.html").write_text(listing(target), encoding="utf-8")
            path = path.rstrip("/") + "/index.html"
        else:
            copy.parent.mkdir(parents=True, exist_ok=True)
            shutil.copyfile(target, copy)
        # mdBook makes an index of each README.
        path = re.sub(r"(^|/)README\.md$", r"\1index.md", path)
        return path + ("#" + fragment if fragment else "")

    for place, file in listed.items():
        link = lambda found: found[1] + (found[2] if is_outside(found[2]) else moved(place, found[2])) + found[3]
        parts = CODE.split(file.read_text(encoding="utf-8"))
        parts[::2] = [LINK.sub(link, part) for part in parts[::2]]
        page = sources / place
        page.parent.mkdir(parents=True, exist_ok=True)
        page.write_text("".join(parts), encoding="utf-8")
    return faults


class Page(HTMLParser):
    """The places and the links of a page that was built."""

    def __init__(self, path: Path) -> None:
        super().__init__()
        self.ids: set[str] = set()
        self.links: list[str] = []
        self.feed(path.read_text(encoding="utf-8"))

    def handle_starttag(self, tag: str, attributes: list[tuple[str, str | None]]) -> None:
        for name, value in attributes:
            if name in ("id", "name") and value:
                self.ids.add(value)
            if name in ("href", "src") and value:
                self.links.append(value)


def broken(book: Path, made: list[str]) -> tuple[int, list[str]]:
    """How many links the site has, and which lead nowhere."""
    # The error page is shown at any place.
    built = {path.resolve(): Page(path) for path in book.rglob("*.html") if path.name not in [*made, "404.html", "toc.html"]}
    count, faults = 0, []
    for path, page in built.items():
        for link in page.links:
            parts = urlsplit(link)
            if parts.scheme or parts.netloc:
                continue
            count += 1
            target = (path.parent / unquote(parts.path)).resolve() if parts.path else path
            place = unquote(parts.fragment)
            is_there = target.is_file() and (not place or target not in built or place in built[target].ids)
            if not is_there:
                faults.append(f"{path.relative_to(book.resolve())}: {link} leads nowhere")
    return count, faults


def main(mdbook: str, report: str, animation: str, folder: Path) -> int:
    sources, book = folder / "src", folder / "book"
    shutil.rmtree(folder, ignore_errors=True)
    sources.mkdir(parents=True)
    made = {"report.html": report, "animation.html": animation}
    faults = assemble(sources, list(made))
    for name, file in made.items():
        shutil.copyfile(file, sources / name)
    shutil.copyfile(HERE / "SUMMARY.md", sources / "SUMMARY.md")
    for name in ("book.toml", "tables.css"):
        shutil.copyfile(HERE / name, folder / name)
    built = subprocess.run([mdbook, "build", folder], stderr=subprocess.PIPE, text=True)
    if built.returncode:
        sys.exit(built.stderr)
    faults += [line.strip() for line in built.stderr.splitlines() if "WARN" in line]
    count, more = broken(book, list(made))
    faults += more
    index = "".join(path.read_text(encoding="utf-8") for path in book.glob("searchindex*.js"))
    if "restitution" not in index:
        faults.append("the search does not find restitution")
    print("\n".join(faults) or f"{book}: {len(pages())} pages, {count} links")
    return min(len(faults), 1)


if __name__ == "__main__":
    sys.exit(main(*sys.argv[1:4], Path(sys.argv[4])))
