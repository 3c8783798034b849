"""Log-log charts as SVG text, for bench/report.py. Python's standard library only."""
import dataclasses
import math
from xml.sax.saxutils import escape

WIDTH, HEIGHT = 760, 430
LEFT, RIGHT, TOP, BOTTOM = 62, 190, 34, 48

# Twelve colours that stay apart on white, for colour-blind readers too when read with the markers.
COLOURS = ["#0b6bcb", "#d1495b", "#2a9d4a", "#8b5fbf", "#c77700", "#00838f", "#6b4f3a", "#d6409f", "#5c7c00", "#37474f",
           "#9a6700", "#4a56c9"]
MARKERS = ["circle", "square", "diamond", "triangle"]


@dataclasses.dataclass
class Series:
    """Points (x, least, middle, most) of one name, ascending by x; a limit is drawn dashed, without markers."""
    name: str
    points: list
    colour: str
    marker: str = "circle"
    limit: bool = False
    joined: bool = True


@dataclasses.dataclass
class Chart:
    title: str
    x_name: str
    y_name: str
    series: list
    x_steps: list = None  # the only values of x, at equal distances; None: a logarithmic scale


def style_of(index):
    """Colour and marker of the series with that number; the pair repeats after a few dozen."""
    return COLOURS[index % len(COLOURS)], MARKERS[index % len(MARKERS)]


class Steps:
    """A few values at equal distances."""

    def __init__(self, numbers, first, last):
        self.numbers, self.first, self.last = numbers, first, last

    def at(self, number):
        return self.first + (self.numbers.index(number) + 0.5) / len(self.numbers) * (self.last - self.first)

    def ticks(self):
        return self.numbers


class Axis:
    """A logarithmic scale from the numbers to pixels."""

    def __init__(self, numbers, first, last):
        low, high = math.log10(min(numbers)), math.log10(max(numbers))
        room = max(0.06 * (high - low), 0.08)
        self.low, self.high, self.first, self.last = low - room, high + room, first, last

    def at(self, number):
        share = (math.log10(number) - self.low) / (self.high - self.low)
        return self.first + share * (self.last - self.first)

    def ticks(self):
        """1, 2, 5 times powers of ten within the scale; only powers where it spans many."""
        factors = (1, 2, 5) if self.high - self.low < 2.5 else (1,)
        exponents = range(math.floor(self.low), math.ceil(self.high) + 1)
        numbers = [factor * 10.0 ** exponent for exponent in exponents for factor in factors]
        return [number for number in numbers if self.low <= math.log10(number) <= self.high]


def number_text(number):
    """1000 -> 1k, 0.05 -> 0.05."""
    for size, unit in ((1e9, "G"), (1e6, "M"), (1e3, "k")):
        if number >= size:
            return f"{number / size:g}{unit}"
    return f"{number:g}"


def text(x, y, content, anchor="start", extra=""):
    return f'<text x="{x:.1f}" y="{y:.1f}" text-anchor="{anchor}" {extra}>{escape(content)}</text>'


def line(x1, y1, x2, y2, colour, extra=""):
    return f'<line x1="{x1:.1f}" y1="{y1:.1f}" x2="{x2:.1f}" y2="{y2:.1f}" stroke="{colour}" {extra}/>'


def marker(shape, x, y, colour, title):
    """A mark of about nine pixels with a tooltip."""
    tip = f"<title>{escape(title)}</title>"
    if shape == "circle":
        return f'<circle cx="{x:.1f}" cy="{y:.1f}" r="4" fill="{colour}">{tip}</circle>'
    shapes = {"square": [(-4, -4), (4, -4), (4, 4), (-4, 4)], "diamond": [(0, -5), (5, 0), (0, 5), (-5, 0)],
              "triangle": [(0, -5), (5, 4), (-5, 4)]}
    points = " ".join(f"{x + dx:.1f},{y + dy:.1f}" for dx, dy in shapes[shape])
    return f'<polygon points="{points}" fill="{colour}">{tip}</polygon>'


def draw_grid(chart, x_axis, y_axis):
    parts = []
    bottom, right = HEIGHT - BOTTOM, WIDTH - RIGHT
    for number in x_axis.ticks():
        x = x_axis.at(number)
        parts += [line(x, TOP, x, bottom, "#e4e7eb"), text(x, bottom + 17, number_text(number), "middle")]
    for number in y_axis.ticks():
        y = y_axis.at(number)
        parts += [line(LEFT, y, right, y, "#e4e7eb"), text(LEFT - 7, y + 4, number_text(number), "end")]
    parts.append(f'<rect x="{LEFT}" y="{TOP}" width="{right - LEFT}" height="{bottom - TOP}" fill="none" stroke="#9aa5b1"/>')
    parts.append(text((LEFT + right) / 2, HEIGHT - 10, chart.x_name, "middle"))
    parts.append(text(14, (TOP + bottom) / 2, chart.y_name, "middle", f'transform="rotate(-90 14 {(TOP + bottom) / 2:.1f})"'))
    parts.append(text(LEFT, 20, chart.title, "start", 'font-weight="600"'))
    return parts


def draw_series(series, x_axis, y_axis):
    places = [(x_axis.at(x), y_axis.at(middle)) for x, _, middle, _ in series.points]
    path = " ".join(f"{x:.1f},{y:.1f}" for x, y in places)
    dashes = 'stroke-dasharray="6 4" stroke-width="1.5"' if series.limit else 'stroke-width="2"'
    parts = [f'<polyline points="{path}" fill="none" stroke="{series.colour}" {dashes}/>'] if series.joined else []
    for (x, least, middle, most), (px, py) in zip(series.points, places):
        tip = f"{series.name}: {middle:.4g} ({least:.4g} - {most:.4g}) at {number_text(x)}"
        if series.limit:
            parts.append(f'<circle cx="{px:.1f}" cy="{py:.1f}" r="6" fill="transparent"><title>{escape(tip)}</title></circle>')
            continue
        parts.append(line(px, y_axis.at(least), px, y_axis.at(most), series.colour, 'stroke-opacity="0.45"'))
        parts.append(marker(series.marker, px, py, series.colour, tip))
    return parts


def draw_legend(all_series):
    """Names beside the chart, in the order of their last values, highest first."""
    parts, x, y = [], WIDTH - RIGHT + 14, TOP + 8
    for series in sorted(all_series, key=lambda each: -each.points[-1][2]):
        dashes = 'stroke-dasharray="6 4" stroke-width="1.5"' if series.limit else 'stroke-width="2"'
        parts.append(line(x, y, x + 22, y, series.colour, dashes))
        if not series.limit:
            parts.append(marker(series.marker, x + 11, y, series.colour, series.name))
        parts.append(text(x + 28, y + 4, series.name))
        y += 19
    return parts


def draw(chart):
    """The chart as one svg element."""
    points = [point for series in chart.series for point in series.points]
    x_axis = (Steps(chart.x_steps, LEFT, WIDTH - RIGHT) if chart.x_steps else
              Axis([point[0] for point in points], LEFT, WIDTH - RIGHT))
    y_axis = Axis([number for point in points for number in point[1:]], HEIGHT - BOTTOM, TOP)
    parts = draw_grid(chart, x_axis, y_axis)
    for series in chart.series:
        parts += draw_series(series, x_axis, y_axis)
    parts += draw_legend(chart.series)
    head = (f'<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 {WIDTH} {HEIGHT}" width="{WIDTH}" height="{HEIGHT}" '
            f'font-family="system-ui, sans-serif" font-size="12" fill="#1f2933" role="img" '
            f'aria-label="{escape(chart.title, {chr(34): "&quot;"})}">')
    background = f'<rect width="{WIDTH}" height="{HEIGHT}" fill="#ffffff"/>'
    return "\n".join([head, background, *parts, "</svg>"])
