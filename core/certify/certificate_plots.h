// SPDX-License-Identifier: Apache-2.0
// The pictures of a certificate.
#pragma once

#include "certify/certificate.h"
#include "certify/pdf_layout.h"

namespace handsight {

/// The expected error over the workspace from above and from the side, uncorrected and corrected.
void draw_maps(const Certificate& certificate, PdfLayout& layout);

/// Measured errors of held-out observations against the limits that were promised for them.
void draw_coverage(const Certificate& certificate, PdfLayout& layout);

}  // namespace handsight
