// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "certify/certificate.h"

namespace handsight {

/// The certificate as a PDF of two to four A4 pages.
std::string certificate_pdf(const Certificate& certificate);

/// Eight digits that tell a certificate from others: of the digests of its files and its date.
std::string certificate_number(const Certificate& certificate);

}  // namespace handsight
