# SPDX-License-Identifier: Apache-2.0
# Comments in code are plain ones: what stands behind a member is what it is, and <joints> is an element of a file.
:again
s|(//.*)<(/?[a-z_]+( [^<>]*)?)>|\1\&lt;\2\&gt;|
t again
s|([;,{}]) +// |\1  ///< |
# How fmt writes a type of ours is no part of the interface, and Doxygen knows no fmt.
/^template <>$/ {
  N
  /struct fmt::formatter/ {
    :rest
    /\n\};/! {
      N
      b rest
    }
    d
  }
}
