#!/usr/bin/env python3
"""Draws the paper's Figure 2: the frame with the centroid as a red circle, and the depth map beside it.

usage: figure_2.py FRAME OUT.png [METHOD]        e.g. figure_2.py data/tunnel.jpg figure_2.png paper

Cells are marked with # %% for editors that run a script piece by piece (VS Code, Spyder, Jupyter through Jupytext).
"""

# %% What we need: the module, numpy, and something that reads and writes pictures.
import sys

import numpy as np
from PIL import Image, ImageDraw

import adit

frame_path, out_path = sys.argv[1:3]
method = sys.argv[3] if len(sys.argv) > 3 else "paper"

# %% A frame. PIL gives RGB, so that is what we tell the finder; nothing is copied.
frame = np.asarray(Image.open(frame_path).convert("RGB"))
finder = adit.OpenSpaceFinder(adit.Config(method=method))
seen, stages = finder.explain(frame, order="rgb")
print(seen, f"judged in {seen.total_ns / 1e6:.2f} ms with {adit.cpu_target()}")

# %% On the left the frame, and where the open space is.
left = Image.fromarray(frame)
if seen.found:
    u, v = seen.centroid_px
    ImageDraw.Draw(left).ellipse((u - 14, v - 14, u + 14, v + 14), outline=(255, 0, 0), width=4)

# %% On the right the closed scattering depth, eq. (2) to (5): what is far is blue, what is near is red, as in the paper.
depth = stages.closing
if depth is None:
    raise SystemExit(f"{frame_path}: no depth was made of it: {seen.status}")
span = max(float(depth.max() - depth.min()), 1e-9)
t = (depth - depth.min()) / span
colours = np.clip(1.5 - np.abs(4.0 * t[..., None] - np.array([3.0, 2.0, 1.0])), 0.0, 1.0)
right = Image.fromarray((255 * colours).astype(np.uint8))

# %% Side by side.
figure = Image.new("RGB", (left.width + right.width + 8, left.height), (255, 255, 255))
figure.paste(left, (0, 0))
figure.paste(right, (left.width + 8, 0))
figure.save(out_path)
