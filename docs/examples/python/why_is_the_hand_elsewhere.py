# SPDX-License-Identifier: Apache-2.0
# %% [markdown]
# # Why is the hand elsewhere?
# A session of a robot that is not as its description says: how far off is the hand, what is missing in the model, and what
# is to be commanded so that the hand arrives. Run it as a program, or cell by cell as a notebook (VS Code, Spyder, Jupytext):
# `python why_is_the_hand_elsewhere.py SESSION [FOLDER FOR THE PICTURES]`
# %%
import pathlib
import sys

import matplotlib.pyplot as plt
import numpy as np

import handsight

session = handsight.read(sys.argv[1] if len(sys.argv) > 1 else "sample_sessions/hidden_3")
out = pathlib.Path(sys.argv[2] if len(sys.argv) > 2 else ".")

# %% [markdown]
# ## The robot as it is described
# The error on observations that the fit has not seen, beside what the noise of the images alone would leave.
# %%
plain = handsight.fit(session)
print(f"{session.title}: {plain.used} observations, {plain.held_out_rms_pixel:.2f} px held out, noise {plain.noise_pixel:.2f} px")

# %% [markdown]
# ## What is missing?
# The candidates for what the model lacks, by the ln of their Bayes factors: how much better the measurements are predicted with
# them. Those beyond the threshold are no chance.
# %%
found = handsight.diagnose(session)
print(found.verdict, "-", found.reason)
named = found.candidates[:6]
figure, axes = plt.subplots(figsize=(7, 3))
axes.barh([f"{c.id or 'a curve'} {', '.join(c.where[:3])}" for c in reversed(named)], [c.ln_bayes_factor for c in reversed(named)])
axes.axvline(found.threshold_ln_bayes_factor, color="black", linestyle=":", label="chance ends here")
axes.set_xlabel("ln of the Bayes factor")
axes.legend(loc="lower right")
figure.tight_layout()
figure.savefig(out / "candidates.png")

# %% [markdown]
# ## The model with it
# One point an observation: the root mean square over its image coordinates. The line is what noise alone leaves.
# %%
better = handsight.improve(session)
for step in better.steps[1:]:
    print(f"  {step.added or 'other names'} at {', '.join(step.where)}: {step.held_out_rms_pixel:.3f} px held out")
figure, axes = plt.subplots(figsize=(7, 3))
for fitted, label in ((plain, "as described"), (better, "with what was missing")):
    errors = {o.id: o.rms_pixel for o in fitted.per_observation}
    axes.semilogy(list(errors), list(errors.values()), ".", label=label)
axes.axhline(better.noise_pixel, color="black", linestyle=":", label="noise")
axes.set_xlabel("observation")
axes.set_ylabel("error, px")
axes.legend()
figure.tight_layout()
figure.savefig(out / "errors.png")

# %% [markdown]
# ## What to command
# Where the hand would be as commanded, and with the corrected angles, for every pose of the session.
# %%
command = handsight.correct(better, session.positions)
before, after = 1e3 * command.error_before_m, 1e3 * command.error_after_m
print(f"The hand is off by {np.median(before):.2f} mm (median); corrected {np.median(after):.5f} mm, +- {1e3 * np.median(command.sigma_m):.2f} mm")
better.calibration.save(out / "calibration.xml")
