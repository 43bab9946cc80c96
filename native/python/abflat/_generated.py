# Generated from core/schema by scripts/generate.mjs, do not edit.
"""The options of each call."""

from __future__ import annotations

from typing import Literal, NamedTuple, TypedDict, Union

Value = Union[bool, float, str]


class OptionInfo(NamedTuple):
    """An option: its name in the schema, its default, its range and what it does."""

    name: str
    default: Value
    range: str
    text: str


class FlattenOptions(TypedDict, total=False):
    """The options of flattening that are plain values, with their defaults."""

    t: Union[float, Literal["auto"]]
    balance: float
    untangle: Literal["auto", "none", "local", "global", "best"]
    linear_solver: Literal["schur", "eigen"]
    memory: Union[float, Literal["auto"]]
    adjacent: bool
    delaunay: bool
    threads: int


FLATTEN_OPTIONS: dict[str, OptionInfo] = {
    "t": OptionInfo("t", "auto", "above 0, or auto", "boundary control coefficient: every interior angle of the boundary is at most t*pi (1 = convex; 2 or more = free boundary, classic ABF; auto = free, or the bounds of least distortion if a free boundary would cross itself)"),
    "balance": OptionInfo("balance", 0, "at least 0 and at most 1", "trade-off between angles and lengths: 0 keeps the angles as flattening found them, 1 keeps areas and lengths as well as possible (least symmetric Dirichlet energy)"),
    "untangle": OptionInfo("untangle", "auto", "auto, none, local, global, best", "how boundary crossings are removed: auto = best when t is auto, none when it is a number; none = keep crossings; the result is not valid; local = tighten only the bounds of the arcs that cross; global = tighten all bounds alike; best = local or global, whichever distorts less"),
    "linear_solver": OptionInfo("linearSolver", "schur", "schur, eigen", "how the linear systems of Newton's method are solved: schur = elimination to two rows per vertex, then sparse factorisation; for large meshes, conjugate gradients preconditioned by one; eigen = the same elimination, factored by Eigen's SimplicialLDLT"),
    "memory": OptionInfo("memory", "auto", "above 0, or auto", "memory for the factor of the solver's matrix, in MB; if it does not fit, the solver uses single precision, or conjugate gradients with multigrid (auto = 3072 in WebAssembly, no limit natively)"),
    "adjacent": OptionInfo("adjacent", False, "", "condition (5): keep boundary angles below 2 pi even if the boundary is free, so that adjacent triangles do not overlap"),
    "delaunay": OptionInfo("delaunay", False, "", "condition (9): make every interior edge of the layout Delaunay, where the connectivity allows it"),
    "threads": OptionInfo("threads", 0, "at least 0 and at most 256, whole", "maximum number of threads, 0 for one per processor; results do not depend on it; small meshes use fewer, and builds without threads use one"),
}


class UnwrapOptions(TypedDict, total=False):
    """The options of unwrapping that are plain values, with their defaults."""

    max_stretch: float
    max_sheared: Union[float, Literal["auto"]]
    front_leeway: float
    balance: float
    orient: bool
    fill_holes: Literal["auto", "never", "always"]
    seam_costs: Literal["sight", "length"]
    symmetric_seams: Literal["auto", "never", "always"]
    t: Union[float, Literal["auto"]]
    straight_seams: bool
    rectify: Literal["auto", "never", "always"]
    resolution: Union[int, tuple[int, int]]
    padding: int
    margin: Union[int, Literal["auto"]]
    texel_density: Union[float, Literal["auto"]]
    udim: bool
    snap_to_texels: bool
    packing_cuts: Literal["auto", "never"]
    min_utilization: Union[float, Literal["auto"]]
    up: Literal["auto", "y", "z"]
    rotate: Literal["auto", "free", "quarter", "none"]
    stack: Literal["none", "identical", "mirrored"]
    memory: Union[float, Literal["auto"]]
    threads: int


UNWRAP_OPTIONS: dict[str, OptionInfo] = {
    "max_stretch": OptionInfo("maxStretch", 1.02, "above 1", "largest stretch of a chart: its mean symmetric Dirichlet energy / 4, where 1 keeps all lengths; smaller values give more seams and charts"),
    "max_sheared": OptionInfo("maxSheared", "auto", "above 0 and at most 1, or auto", "largest share of a chart's surface that may be sheared, that is, have a quasi-conformal distortion above 1.25, as if a square became a rectangle of 5 by 4; charts with more are cut further (1 = no limit; auto = 0.1, or 5 times what maxStretch is above 1, if that is more)"),
    "front_leeway": OptionInfo("frontLeeway", 14, "at least 1 and at most 100", "how much more the front of a figure, such as a face, may be stretched so that no seam crosses it: so many times maxStretch - 1, and as many times maxSheared; half as much again on a mask that then needs no seam at all (1 = no more than elsewhere)"),
    "balance": OptionInfo("balance", 0.2, "at least 0 and at most 1", "trade-off between angles and lengths: 0 keeps the angles as flattening found them, 1 keeps areas and lengths as well as possible (least symmetric Dirichlet energy)"),
    "orient": OptionInfo("orient", False, "", "turn faces so that neighbours run alike, in the layout and in the output, before seams are placed; normals stay as they are"),
    "fill_holes": OptionInfo("fillHoles", "auto", "auto, never, always", "whether holes in charts, such as eye sockets and windows, are treated as filled and need no seams: auto = fill small or flat holes, unless a seam reaches them or the chart would be stretched too much; never = connect every hole to the outer boundary by a seam; always = fill them, however much that stretches"),
    "seam_costs": OptionInfo("seamCosts", "sight", "sight, length", "what automatic seams are to have little of: sight = how much they are in sight: creases hide seams, flat faces and the face of a figure do not; length = their length alone, as papers and patterns have it"),
    "symmetric_seams": OptionInfo("symmetricSeams", "auto", "auto, never, always", "whether automatic seams of a symmetric mesh are symmetric; parts without a mirror image do not matter: auto = symmetric unless that makes seams more than a tenth costlier; never = place each seam where it is best for its own side; always = symmetric whatever that costs"),
    "t": OptionInfo("t", "auto", "above 0, or auto", "boundary control coefficient: every interior angle of the boundary is at most t*pi (1 = convex; 2 or more = free boundary, classic ABF; auto = free, or the bounds of least distortion if a free boundary would cross itself)"),
    "straight_seams": OptionInfo("straightSeams", False, "", "make seams and boundaries straight in the atlas, from junction to junction and corner to corner; curves that turn by more than 90 degrees in all, such as the rim of a round lid, stay curved"),
    "rectify": OptionInfo("rectify", "auto", "auto, never, always", "whether outlines that are nearly straight become exactly so, and strips rectangles: auto = where that hardly stretches, and stays within the bound of stretch; never = leave outlines as they come out; always = however much that stretches"),
    "resolution": OptionInfo("resolution", 1024, "at least 16 and at most 32768, whole, or two of these, as in (2048, 1024)", "side of the texture in texels, or its width and height"),
    "padding": OptionInfo("padding", 2, "at least 0 and at most 256, whole", "free texels between charts, and between far parts of one chart"),
    "margin": OptionInfo("margin", "auto", "at least 0 and at most 256, whole, or auto", "free texels between charts and the edge of their tile (auto = half the padding, rounded up)"),
    "texel_density": OptionInfo("texelDensity", "auto", "above 0, or auto", "texels per mesh unit; use the same value for meshes that belong together (auto = as many as fit in one tile)"),
    "udim": OptionInfo("udim", False, "", "use as many UDIM tiles as the texel density needs: from 1001 on, ten per row, u from 0 to 10"),
    "snap_to_texels": OptionInfo("snapToTexels", False, "", "stretch level charts to whole texels, so that their sides lie on borders of texels"),
    "packing_cuts": OptionInfo("packingCuts", "auto", "auto, never", "whether charts may be cut so that all pack tighter: auto = where that gains enough texels, see minUtilization; never = every chart stays whole"),
    "min_utilization": OptionInfo("minUtilization", "auto", "at least 0 and at most 1, or auto", "share of the tile that charts should cover: charts are cut until they do, or until cutting stops helping, and then a note says why (0 = leave charts whole, like packingCuts = never; auto = cut long charts across, and others along creases, where that gains at least 5 % texels per unit for each of the first four cuts, 1.5 % per further cut, and 4 % per seam in plain sight as long as the square root of the surface area)"),
    "up": OptionInfo("up", "auto", "auto, y, z", "which axis of the mesh points up: charts that stand are laid out upright, and a face is looked for at the sides: auto = z in STL files, y in all others; y = the y axis; z = the z axis"),
    "rotate": OptionInfo("rotate", "auto", "auto, free, quarter, none", "how charts, which lie level and upright, are turned to pack tighter: auto = by quarter turns, and charts whose outlines are not straight by any angle where that gains 4 % texels per unit or more; free = by any angle where that gains 3 % texels per unit or more, with up to 40 charts 5 %; quarter = by quarter turns only; none = not at all"),
    "stack": OptionInfo("stack", "none", "none, identical, mirrored", "which parts and charts of equal shape lie on each other and share their texels: none = each has texels of its own; identical = those that are moved and turned; mirrored = mirror images as well, whose triangles run clockwise in the atlas"),
    "memory": OptionInfo("memory", "auto", "above 0, or auto", "memory for the factor of the solver's matrix, in MB; if it does not fit, the solver uses single precision, or conjugate gradients with multigrid (auto = 3072 in WebAssembly, no limit natively)"),
    "threads": OptionInfo("threads", 0, "at least 0 and at most 256, whole", "maximum number of threads, 0 for one per processor; results do not depend on it; small meshes use fewer, and builds without threads use one"),
}


class PackOptions(TypedDict, total=False):
    """The options of packing a layout that are plain values, with their defaults."""

    resolution: Union[int, tuple[int, int]]
    padding: int
    margin: Union[int, Literal["auto"]]
    texel_density: Union[float, Literal["auto"]]
    udim: bool
    snap_to_texels: bool
    rotate: Literal["auto", "free", "quarter", "none"]
    island_sizes: Literal["keep", "even"]
    keep_places: bool
    threads: int


PACK_OPTIONS: dict[str, OptionInfo] = {
    "resolution": OptionInfo("resolution", 1024, "at least 16 and at most 32768, whole, or two of these, as in (2048, 1024)", "side of the texture in texels, or its width and height"),
    "padding": OptionInfo("padding", 2, "at least 0 and at most 256, whole", "free texels between islands"),
    "margin": OptionInfo("margin", "auto", "at least 0 and at most 256, whole, or auto", "free texels between islands and the edge of their tile (auto = half the padding, rounded up)"),
    "texel_density": OptionInfo("texelDensity", "auto", "above 0, or auto", "texels per mesh unit; use the same value for meshes that belong together (auto = as many as fit in one tile)"),
    "udim": OptionInfo("udim", False, "", "use as many UDIM tiles as the texel density needs: from 1001 on, ten per row, u from 0 to 10"),
    "snap_to_texels": OptionInfo("snapToTexels", False, "", "stretch level islands to whole texels, so that their sides lie on borders of texels"),
    "rotate": OptionInfo("rotate", "auto", "auto, free, quarter, none", "how islands are turned from how they lie to pack tighter: auto = by quarter turns, and charts whose outlines are not straight by any angle where that gains 4 % texels per unit or more; free = by any angle where that gains 3 % texels per unit or more, with up to 40 charts 5 %; quarter = by quarter turns only; none = not at all"),
    "island_sizes": OptionInfo("islandSizes", "keep", "keep, even", "how large islands are beside each other: keep = as large to each other as they are; even = the same texel density for all; islands that lie on each other share one scale"),
    "keep_places": OptionInfo("keepPlaces", False, "", "islands stay where they are, and the layout is only judged; of the other options only resolution and udim count then"),
    "threads": OptionInfo("threads", 0, "at least 0 and at most 256, whole", "maximum number of threads, 0 for one per processor; results do not depend on it; small meshes use fewer, and builds without threads use one"),
}


class VerifyOptions(TypedDict, total=False):
    """What a layout must keep to, as plain values, with their defaults."""

    resolution: Union[int, tuple[int, int]]
    udim: bool
    padding: float
    margin: float
    mip_levels: int
    min_island_width: float
    min_texel_density: Union[float, Literal["none"]]
    max_texel_density: Union[float, Literal["none"]]
    max_density_ratio: Union[float, Literal["none"]]
    max_stretch: Union[float, Literal["none"]]
    min_utilization: float
    max_islands: Union[int, Literal["none"]]
    allow_stacked: bool
    allow_mirrored: bool
    allow_overlaps: bool
    allow_outside_tiles: bool
    allow_empty: bool
    allow_unmapped: bool


VERIFY_OPTIONS: dict[str, OptionInfo] = {
    "resolution": OptionInfo("resolution", 1024, "at least 16 and at most 32768, whole, or two of these, as in (2048, 1024)", "side of the texture in texels, or its width and height: for distances, widths and texel densities"),
    "udim": OptionInfo("udim", False, "", "islands may lie in any UDIM tile: from 1001 on, ten per row, u from 0 to 10"),
    "padding": OptionInfo("padding", 0, "at least 0 and at most 1024", "least distance between two islands in texels"),
    "margin": OptionInfo("margin", 0, "at least 0 and at most 1024", "least distance between an island and the edge of its tile in texels"),
    "mip_levels": OptionInfo("mipLevels", 0, "at least 0 and at most 15, whole", "mip levels below the texture in which padding and margin must hold, too: distances are half as many texels in each"),
    "min_island_width": OptionInfo("minIslandWidth", 0, "at least 0 and at most 32768", "least width of an island in texels, across the shorter side of its smallest box"),
    "min_texel_density": OptionInfo("minTexelDensity", "none", "above 0, or none", "least texels per mesh unit of a face; a glTF is in metres"),
    "max_texel_density": OptionInfo("maxTexelDensity", "none", "above 0, or none", "most texels per mesh unit of a face"),
    "max_density_ratio": OptionInfo("maxDensityRatio", "none", "at least 1, or none", "how many times as dense as another an island may be"),
    "max_stretch": OptionInfo("maxStretch", "none", "above 1, or none", "largest stretch of an island: its mean symmetric Dirichlet energy / 4, where 1 keeps all lengths"),
    "min_utilization": OptionInfo("minUtilization", 0, "at least 0 and at most 1", "least share of the tiles that islands cover"),
    "max_islands": OptionInfo("maxIslands", "none", "at least 1 and at most 1000000000, whole, or none", "most islands"),
    "allow_stacked": OptionInfo("allowStacked", False, "", "islands may lie on each other if they cover the same place"),
    "allow_mirrored": OptionInfo("allowMirrored", False, "", "whole islands may run clockwise"),
    "allow_overlaps": OptionInfo("allowOverlaps", False, "", "islands may overlap others and themselves"),
    "allow_outside_tiles": OptionInfo("allowOutsideTiles", False, "", "islands may leave their tile, as with textures that repeat"),
    "allow_empty": OptionInfo("allowEmpty", False, "", "faces with area may have none in uv"),
    "allow_unmapped": OptionInfo("allowUnmapped", False, "", "faces may be without texcoords"),
}


# The bits for what is wrong with a face in uv.
UV_FAULT: dict[str, int] = {
    "overlapping": 1,
    "flipped": 2,
    "empty": 4,
    "outside": 8,
}
