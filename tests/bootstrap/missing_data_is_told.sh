#!/usr/bin/env bash
# missing_data_is_told.sh REAL_SERIES_TEST: without its data the program skips, or fails where data is required.
set -euo pipefail
export PDR_SHARED=/nonexistent
unset PDR_REQUIRE_DATA
"$1" | grep -E "Totals: [0-2] passed, 0 failed, [1-9][0-9]* skipped" >/dev/null
! PDR_REQUIRE_DATA=1 "$1" >/dev/null
