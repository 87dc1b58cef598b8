// SPDX-License-Identifier: Apache-2.0
#include "bill_output.h"

#include "json_values.h"

namespace handsight::cli {

void print_bill(const Output& out, const std::vector<BillRow>& rows) {
  const std::vector<std::string> lines = bill_lines(rows);
  if (lines.empty()) return;
  out.line();
  for (const std::string& line : lines) out.line(line);
  out.line();
}

Json bill_json(const std::vector<BillRow>& rows) {
  Json list = Json::array();
  const Json null = nullptr;
  for (const BillRow& row : rows)
    list.push_back({{"id", row.id},
                    {"where", row.where},
                    {"unnamed", row.unnamed},
                    {"follows", row.follows.empty() ? null : Json(row.follows)},
                    {"held", row.held},
                    {"a_little_at_each_joint", row.is_small},
                    {"hand_m", number(row.hand_m)},
                    {"hand_sigma_m", row.held ? null : number(row.hand_sigma_m)},
                    {"probability", number(row.probability)},
                    {"too_large", row.too_large},
                    {"pushes_back", row.pushes_back},
                    {"stands_in_at", row.stands_in_at},
                    {"cannot_be_told_from", row.indistinguishable_from ? Json(*row.indistinguishable_from) : null}});
  return list;
}

}  // namespace handsight::cli
