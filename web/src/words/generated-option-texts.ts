// Generated from core/schema by scripts/generate.mjs, do not edit.

export const UNWRAP_TEXTS = {
  maxStretch: 'largest stretch of a chart: its mean symmetric Dirichlet energy / 4, where 1 keeps all lengths; smaller values give more seams and charts',
  maxSheared: 'largest share of a chart\'s surface that may be sheared, that is, have a quasi-conformal distortion above 1.25, as if a square became a rectangle of 5 by 4; charts with more are cut further (1 = no limit; auto = 0.1, or 5 times what maxStretch is above 1, if that is more)',
  frontLeeway: 'how much more the front of a figure, such as a face, may be stretched so that no seam crosses it: so many times maxStretch - 1, and as many times maxSheared; half as much again on a mask that then needs no seam at all (1 = no more than elsewhere)',
  balance: 'trade-off between angles and lengths: 0 keeps the angles as flattening found them, 1 keeps areas and lengths as well as possible (least symmetric Dirichlet energy)',
  orient: 'turn faces so that neighbours run alike, in the layout and in the output, before seams are placed; normals stay as they are',
  fillHoles: 'whether holes in charts, such as eye sockets and windows, are treated as filled and need no seams: auto = fill small or flat holes, unless a seam reaches them or the chart would be stretched too much; never = connect every hole to the outer boundary by a seam; always = fill them, however much that stretches',
  seamCosts: 'what automatic seams are to have little of: sight = how much they are in sight: creases hide seams, flat faces and the face of a figure do not; length = their length alone, as papers and patterns have it',
  symmetricSeams: 'whether automatic seams of a symmetric mesh are symmetric; parts without a mirror image do not matter: auto = symmetric unless that makes seams more than a tenth costlier; never = place each seam where it is best for its own side; always = symmetric whatever that costs',
  t: 'boundary control coefficient: every interior angle of the boundary is at most t*pi (1 = convex; 2 or more = free boundary, classic ABF; auto = free, or the bounds of least distortion if a free boundary would cross itself)',
  straightSeams: 'make seams and boundaries straight in the atlas, from junction to junction and corner to corner; curves that turn by more than 90 degrees in all, such as the rim of a round lid, stay curved',
  rectify: 'whether outlines that are nearly straight become exactly so, and strips rectangles: auto = where that hardly stretches, and stays within the bound of stretch; never = leave outlines as they come out; always = however much that stretches',
  resolution: 'side of the texture in texels, or its width and height',
  padding: 'free texels between charts, and between far parts of one chart',
  margin: 'free texels between charts and the edge of their tile (auto = half the padding, rounded up)',
  texelDensity: 'texels per mesh unit; use the same value for meshes that belong together (auto = as many as fit in one tile)',
  udim: 'use as many UDIM tiles as the texel density needs: from 1001 on, ten per row, u from 0 to 10',
  packingCuts: 'whether charts may be cut so that all pack tighter: auto = where that gains enough texels, see minUtilization; never = every chart stays whole',
  minUtilization: 'share of the tile that charts should cover: charts are cut until they do, or until cutting stops helping, and then a note says why (0 = leave charts whole, like packingCuts = never; auto = cut long charts across, and others along creases, where that gains at least 5 % texels per unit for each of the first four cuts, 1.5 % per further cut, and 4 % per seam in plain sight as long as the square root of the surface area)',
  up: 'which axis of the mesh points up: charts that stand are laid out upright, and a face is looked for at the sides: auto = z in STL files, y in all others; y = the y axis; z = the z axis',
  rotate: 'how charts, which lie level and upright, are turned to pack tighter: auto = by quarter turns, and charts whose outlines are not straight by any angle where that gains 4 % texels per unit or more; free = by any angle where that gains 3 % texels per unit or more; quarter = by quarter turns only; none = not at all',
  stack: 'which parts and charts of equal shape lie on each other and share their texels: none = each has texels of its own; identical = those that are moved and turned; mirrored = mirror images as well, whose triangles run clockwise in the atlas',
  memory: 'memory for the factor of the solver\'s matrix, in MB; if it does not fit, the solver uses single precision, or conjugate gradients with multigrid (auto = 3072 in WebAssembly, no limit natively)',
  threads: 'maximum number of threads, 0 for one per processor; results do not depend on it; small meshes use fewer, and builds without threads use one',
} as const;

export const PACK_TEXTS = {
  resolution: 'side of the texture in texels, or its width and height',
  padding: 'free texels between islands',
  margin: 'free texels between islands and the edge of their tile (auto = half the padding, rounded up)',
  texelDensity: 'texels per mesh unit; use the same value for meshes that belong together (auto = as many as fit in one tile)',
  udim: 'use as many UDIM tiles as the texel density needs: from 1001 on, ten per row, u from 0 to 10',
  rotate: 'how islands are turned from how they lie to pack tighter: auto = by quarter turns, and charts whose outlines are not straight by any angle where that gains 4 % texels per unit or more; free = by any angle where that gains 3 % texels per unit or more; quarter = by quarter turns only; none = not at all',
  islandSizes: 'how large islands are beside each other: keep = as large to each other as they are; even = the same texel density for all; islands that lie on each other share one scale',
  keepPlaces: 'islands stay where they are, and the layout is only judged; of the other options only resolution and udim count then',
  threads: 'maximum number of threads, 0 for one per processor; results do not depend on it; small meshes use fewer, and builds without threads use one',
} as const;
