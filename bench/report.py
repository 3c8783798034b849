#!/usr/bin/env python3
"""Turns the JSON of `honeycomb bench --json F` into one HTML page: how time a vertex scales with the mesh and the level,
how near the evaluators come to what the memory can take, and by how much they differ. Python's standard library only.

    bench/report.py FILE.json ... [--out report.html] [--svg FOLDER]

Files of several meshes, such as of 1k, 10k, 100k and 1M faces, make one plot. --svg keeps the charts as files too.
"""
import argparse
import collections
import json
import pathlib
import re
import sys
from xml.sax.saxutils import escape

from report_chart import Chart, Series, draw, style_of

PEERS = ["opensubdiv-cpu", "csr", "serial"]
LIMITS = {"write_gb_s": "plain writes", "write_nt_gb_s": "non-temporal writes", "copy_gb_s": "copies"}
LIMIT_COLOUR = {"write_gb_s": "#52606d", "write_nt_gb_s": "#9aa5b1", "copy_gb_s": "#cbb26a"}
STYLE = """
body { font: 15px/1.45 system-ui, sans-serif; color: #1f2933; background: #fff; max-width: 1080px; margin: 2em auto; padding: 0 1em }
h1 { font-size: 1.6em } h2 { font-size: 1.2em; margin-top: 2em }
table { border-collapse: collapse; margin: .8em 0; font-variant-numeric: tabular-nums }
th, td { padding: .22em .7em; border-bottom: 1px solid #e4e7eb; text-align: right } th:first-child, td:first-child { text-align: left }
th { border-bottom: 2px solid #9aa5b1; font-weight: 600 } svg { max-width: 100%; height: auto; display: block; margin: 1em 0 }
.note { color: #52606d } .scroll { overflow-x: auto }
"""


def load(files):
    """All files as one, each entry with the limits of its own file."""
    merged = {"machines": [], "runs": [], "skipped": [], "build": []}
    for file in files:
        try:
            data = json.loads(pathlib.Path(file).read_text(encoding="utf-8"))
            for run in data["runs"]:
                run["limits"] = limits_of(data, run)
            merged["machines"].append((file, data["machine"]))
            for part in ("runs", "skipped", "build"):
                merged[part] += data[part]
        except (OSError, ValueError, KeyError, TypeError) as error:
            sys.exit(f"error: {file}: can't be read as the JSON of honeycomb bench: {error!r}")
    if not merged["runs"]:
        sys.exit("error: there are no runs in these files")
    return merged


def limits_of(data, run):
    """The limits on all threads that were measured in turns with a run: name -> spread in GB/s, and the bytes."""
    found = {}
    for entry in data["limits"]["measured"]:
        if (entry["level"], entry["layout"]) == (run["level"], run["layout"]):
            if entry["threads"] == data["machine"]["threads"] or entry["limit"] not in found:
                found[entry["limit"]] = {"gb_s": entry["gb_s"], "bytes": entry["bytes"]}
    return found


def rates(run):
    """GB/s of output: least, middle, most."""
    time = run["ns_per_vertex"]
    return [run["output_bytes_per_vertex"] / time[key] for key in ("max", "median", "min")]


def grouped(entries, *keys):
    """Entries by the values of these keys, in the order they come."""
    groups = collections.OrderedDict()
    for entry in entries:
        groups.setdefault(tuple(entry[key] for key in keys), []).append(entry)
    return groups


class Styles:
    """An evaluator has the same colour and marker in every chart."""

    def __init__(self, names):
        self.names = list(collections.OrderedDict.fromkeys(names))

    def series(self, name, points, joined=True):
        colour, marker = style_of(self.names.index(name))
        return Series(name, sorted(points), colour, marker, joined=joined)


def time_series(runs, key, styles):
    points = collections.OrderedDict()
    for run in runs:
        time = run["ns_per_vertex"]
        points.setdefault(run["evaluator"], []).append((run[key], time["min"], time["median"], time["max"]))
    return [styles.series(name, each) for name, each in points.items()]


def kind_of(mesh):
    """Meshes that were made have a name, files theirs."""
    return pathlib.PurePath(mesh).name


def scaling_charts(runs, styles):
    """ns a vertex against control faces, where meshes of one kind come in several sizes."""
    charts = []
    for (scheme, mesh, level, layout), group in grouped(runs, "scheme", "mesh", "level", "layout").items():
        if len({run["control_faces"] for run in group}) > 1:
            charts.append(Chart(f"{scheme}, {kind_of(mesh)}, level {level}, {layout}", "control faces", "ns per refined vertex",
                                time_series(group, "control_faces", styles)))
    return charts


def level_charts(runs, styles):
    """ns a vertex against the level."""
    charts = []
    for (scheme, mesh, faces, layout), group in grouped(runs, "scheme", "mesh", "control_faces", "layout").items():
        levels = sorted({run["level"] for run in group})
        if len(levels) > 1:
            charts.append(Chart(f"{scheme}, {kind_of(mesh)} of {faces:,} faces, {layout}", "level", "ns per refined vertex",
                                time_series(group, "level", styles), levels))
    return charts


def roofline_charts(runs, styles):
    """GB/s of output against the bytes of the output, below the limits measured in the same runs."""
    charts = []
    for (scheme, layout), group in grouped(runs, "scheme", "layout").items():
        points, limits = collections.OrderedDict(), collections.OrderedDict()
        for run in group:
            size = run["refined_vertices"] * run["output_bytes_per_vertex"]
            points.setdefault(run["evaluator"], []).append((size, *rates(run)))
            for name, limit in run["limits"].items():
                spread = limit["gb_s"]
                limits.setdefault(name, {})[limit["bytes"]] = (limit["bytes"], spread["min"], spread["median"], spread["max"])
        series = [Series(LIMITS.get(name, name), sorted(each.values()), LIMIT_COLOUR.get(name, "#777777"), limit=True)
                  for name, each in limits.items()]
        series += [styles.series(name, each, joined=False) for name, each in points.items()]
        charts.append(Chart(f"{scheme}, {layout}: output against the memory's limits", "bytes of the output",
                            "GB/s of output", series))
    return charts


def table(head, rows):
    cells = ["<tr>" + "".join(f"<th>{escape(cell)}</th>" for cell in head) + "</tr>"]
    cells += ["<tr>" + "".join(f"<td>{escape(cell)}</td>" for cell in row) + "</tr>" for row in rows]
    return '<div class="scroll"><table>' + "\n".join(cells) + "</table></div>"


def ratio(over, under):
    return f"{over / under:.2f}x" if over and under else ""


def run_tables(runs):
    """One table a mesh, level and layout: times, and by what factor each evaluator is faster than the peers."""
    parts = []
    keys = ("scheme", "mesh", "control_faces", "level", "layout", "normals")
    for (scheme, mesh, faces, level, layout, normals), group in grouped(runs, *keys).items():
        median = {run["evaluator"]: run["ns_per_vertex"]["median"] for run in group}
        peers = [peer for peer in PEERS if peer in median]
        head = ["evaluator", "threads", "ns/vertex", "least - most", "cpu ns", "GB/s", "of the write limit",
                *[f"faster than {peer}" for peer in peers], "table bytes/vertex", "build ms"]
        rows = []
        for run in sorted(group, key=lambda each: each["ns_per_vertex"]["median"]):
            time, rate = run["ns_per_vertex"], rates(run)[1]
            best = max((limit["gb_s"]["median"] for name, limit in run["limits"].items() if name.startswith("write")), default=0)
            rows.append([run["evaluator"], str(run["threads"] or "device"), f"{time['median']:.3f}",
                         f"{time['min']:.3f} - {time['max']:.3f}", f"{run['cpu_ns_per_vertex']['median']:.3f}", f"{rate:.2f}",
                         f"{100 * rate / best:.0f} %" if best else "", *[ratio(median[peer], time["median"]) for peer in peers],
                         f"{run['table_bytes'] / run['refined_vertices']:.1f}", f"{run['build_ms']:.1f}"])
        besides = "" if normals == "none" else f", {normals} normals"
        parts.append(f"<h3>{escape(f'{scheme}, {kind_of(mesh)} of {faces:,} faces, level {level}, {layout}{besides}')}</h3>")
        parts.append(table(head, rows))
    return parts


def build_tables(builds):
    """What building takes, and OpenSubdiv's time over each of ours."""
    parts = []
    for (scheme, mesh, faces, level), group in grouped(builds, "scheme", "mesh", "control_faces", "level").items():
        foreign = {entry["what"]: entry["ns_per_vertex"]["median"] for entry in group if entry["library"] == "opensubdiv"}
        peers = {"control": ["control"], "topology": ["topology"], "full-topology": ["full-topology"], "tables": ["topology", "stencils"], "flattened": ["stencils"]}
        rows = []
        for entry in group:
            time = entry["ns_per_vertex"]
            peer = sum(foreign.get(what, 0) for what in peers.get(entry["what"], []))
            rows.append([f"{entry['library']} {entry['what']}", f"{time['median']:.3f}", f"{time['min']:.3f} - {time['max']:.3f}",
                         ratio(peer, time["median"]) if entry["library"] == "honeycomb" else "", f"{entry['bytes']:,}"])
        parts.append(f"<h3>{escape(f'{scheme}, {kind_of(mesh)} of {faces:,} faces, level {level}')}</h3>")
        parts.append(table(["what", "ns/vertex", "least - most", "faster than OpenSubdiv", "bytes"], rows))
    return parts


def machine_part(machines):
    rows = []
    for file, machine in machines:
        caches = ", ".join(f"L{cache['level']} {cache['type'].lower()} {cache['bytes'] // 1024:,} kB" for cache in machine["caches"])
        rows.append([file, machine["processor"], str(machine["threads"]), caches, machine["compiler"], machine["flags"].strip()])
    return [table(["file", "processor", "threads", "caches", "compiler", "flags"], rows)]


def skipped_part(skipped):
    if not skipped:
        return []
    rows = sorted({(entry["evaluator"], f"{kind_of(entry['mesh'])} of {entry['control_faces']:,}, level {entry['level']}, "
                    f"{entry['layout']}", entry["why"]) for entry in skipped})
    return ["<h2>Not measured</h2>", table(["evaluator", "what", "why"], rows)]


def page(data, charts):
    parts = ["<h1>honeycomb bench</h1>", *machine_part(data["machines"]),
             '<p class="note">Evaluators had their turns in one process, and their points were compared with the serial '
             "evaluator's before. A refined vertex is one of the last level; levels in between are included. Bars show the "
             "least and the most of all turns.</p>"]
    for heading, drawn in charts.items():
        if drawn:
            parts += [f"<h2>{heading}</h2>", *drawn]
    parts += ["<h2>Ratios</h2>", *run_tables(data["runs"])]
    if data["build"]:
        parts += ["<h2>Building tables</h2>", '<p class="note">tables: topology and level tables, against topology and stencils '
                  "of OpenSubdiv's Catmull-Clark at about as many vertices.</p>", *build_tables(data["build"])]
    parts += skipped_part(data["skipped"])
    body = "\n".join(parts)
    return (f'<!doctype html>\n<html lang="en"><head><meta charset="utf-8"><title>honeycomb bench</title>'
            f"<style>{STYLE}</style></head><body>\n{body}\n</body></html>\n")


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("files", nargs="+", metavar="FILE", help="JSON of honeycomb bench")
    parser.add_argument("--out", default="report.html", help="the page (report.html)")
    parser.add_argument("--svg", metavar="FOLDER", help="write the charts here too")
    options = parser.parse_args()
    data = load(options.files)
    styles = Styles(run["evaluator"] for run in data["runs"])
    sections = {"Scaling with the mesh": scaling_charts(data["runs"], styles),
                "Scaling with the level": level_charts(data["runs"], styles),
                "Against the memory's limits": roofline_charts(data["runs"], styles)}
    drawn = {heading: [draw(chart) for chart in charts] for heading, charts in sections.items()}
    pathlib.Path(options.out).write_text(page(data, drawn), encoding="utf-8")
    if options.svg:
        pathlib.Path(options.svg).mkdir(parents=True, exist_ok=True)
        for charts in sections.values():
            for chart in charts:
                name = re.sub(r"[^a-z0-9]+", "-", f"{chart.title} by {chart.x_name}".lower()).strip("-")
                (pathlib.Path(options.svg) / f"{name}.svg").write_text(draw(chart), encoding="utf-8")


if __name__ == "__main__":
    main()
