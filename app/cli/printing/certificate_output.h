// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "certify/certificate.h"
#include "command.h"

namespace handsight::cli {

Json certificate_json(const Certificate& certificate);

/// The figures that matter, for people.
void print_certificate(const Output& output, const Certificate& certificate);

}  // namespace handsight::cli
