# SPDX-License-Identifier: Apache-2.0
# %% [markdown]
# # How sure is the hand's place where nothing was measured?
# A calibration predicts the hand in any pose, with its uncertainty. Here: two joints are moved over their ranges, the others
# stay, and one sees how far the hand is off, and how sure that is, near the measured poses and far from them.
# `python how_sure_elsewhere.py SESSION [FOLDER FOR THE PICTURES]`
# %%
import pathlib
import sys

import matplotlib.pyplot as plt
import numpy as np

import handsight

session = handsight.read(sys.argv[1] if len(sys.argv) > 1 else "sample_sessions/hidden_1")
out = pathlib.Path(sys.argv[2] if len(sys.argv) > 2 else ".")

# %% [markdown]
# ## A model that is told what there is
# "joint_offset" stands for offsets at every joint, estimated. What the measurements do not show stays at its prior sigma, and as
# unsure as that.
# %%
model = handsight.fit(session, effects=["joint_offset", "encoder_eccentricity"])
print(f"{session.title}: {model.held_out_rms_pixel:.3f} px held out, noise {model.noise_pixel:.3f} px")

# %% [markdown]
# ## Over two joints
# %%
first, second = 1, 2
steps = 41
middle = np.median(session.positions, axis=0)
ranges = [np.linspace(q.min() - 0.8, q.max() + 0.8, steps) for q in (session.positions[:, first], session.positions[:, second])]
poses = np.tile(middle, (steps * steps, 1))
poses[:, first], poses[:, second] = (grid.ravel() for grid in np.meshgrid(*ranges))
there = handsight.predict(model, poses)
off = 1e3 * np.linalg.norm((there.root_from_tcp_est - there.root_from_tcp)[:, :3, 3], axis=1).reshape(steps, steps)
sure = 1e3 * np.linalg.norm(there.sigma[:, :3], axis=1).reshape(steps, steps)

figure, axes = plt.subplots(1, 2, figsize=(10, 4), sharey=True)
for ax, values, title in zip(axes, (off, sure), ("off by, mm", "its standard deviation, mm")):
    shown = ax.pcolormesh(*ranges, values, shading="nearest")
    ax.plot(session.positions[:, first], session.positions[:, second], "w.", markersize=3)
    ax.set_title(title)
    ax.set_xlabel(f"{session.joints[first]}, rad")
    figure.colorbar(shown, ax=ax)
axes[0].set_ylabel(f"{session.joints[second]}, rad")
figure.tight_layout()
figure.savefig(out / "how_sure.png")

# %% [markdown]
# White points are the measured poses. Inside their range the standard deviation is small, outside it grows.
# %%
middle_of = slice(steps // 2 - 5, steps // 2 + 6)
inside, edge = np.median(sure[middle_of, middle_of]), np.median(np.concatenate([sure[0], sure[-1]]))
print(f"standard deviation {inside:.3f} mm in the middle of the measured poses, {edge:.3f} mm at the edge of the map")
