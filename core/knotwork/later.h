#pragma once

/// The page's module comes in parts: the first holds what the first figure needs. What is reached through functions
/// marked KNOTWORK_LATER alone is loaded behind the first picture (web/cmake/split_module.mjs finds the mark in the
/// functions' names). Elsewhere the mark means nothing.
#define KNOTWORK_LATER [[gnu::noinline, gnu::abi_tag("later")]]

/// Marks what Bezier curves do without as well: it is loaded when the reader comes near the chapter behind theirs.
#define KNOTWORK_LAST [[gnu::noinline, gnu::abi_tag("last")]]

/// Marks a function that makes a row of a table, whose functions without captures (a parameter's `set`, say) belong to
/// a later part, but not itself, as the table is made at the start.
#define KNOTWORK_LATER_ROW [[gnu::abi_tag("rows")]]
