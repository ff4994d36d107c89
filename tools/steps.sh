# Sourced by quickstart, run-tests and .ci/run, which stand in the repository's root: one line a step.

# step NAME WORDS COMMAND...: runs COMMAND with its output in build/NAME.log, prints WORDS and the seconds it
# took; on failure prints the log's tail and returns COMMAND's status.
step() {
  local name=$1 words=$2 start=$SECONDS status=0
  shift 2
  mkdir -p build
  printf '%s ... ' "$words"
  "$@" > "build/$name.log" 2>&1 < /dev/null || status=$?
  if [[ $status -eq 0 ]]; then
    echo "$((SECONDS - start)) s"
  else
    echo "failed after $((SECONDS - start)) s (status $status), the end of build/$name.log:"
    tail -n "${STEP_TAIL:-40}" "build/$name.log"
  fi
  return "$status"
}

# configure_and_build PRESET [CMAKE_ARGUMENT...] [-- TARGET...]: in build/PRESET.
configure_and_build() {
  local preset=$1 arguments=() targets=()
  shift
  while [[ $# -gt 0 && $1 != -- ]]; do
    arguments+=("$1")
    shift
  done
  [[ $# -le 1 ]] || targets=(--target "${@:2}")
  step "$preset-configure" "configure $preset" cmake --preset "$preset" "${arguments[@]}" &&
    step "$preset-build" "build $preset" cmake --build "build/$preset" --parallel "$(jobs_here)" "${targets[@]}"
}

# As many jobs as processors.
jobs_here() { echo "${BLYSK_JOBS:-$(nproc)}"; }

# run_ctest PRESET [CTEST_ARGUMENT...]: ctest's summary, then "N passed, N failed, N skipped" as the last line.
run_ctest() {
  local preset=$1 log=build/$1-test.log report=$PWD/build/$1-test.xml status=0
  shift
  rm -f "$report"
  ctest --test-dir "build/$preset" --parallel "$(jobs_here)" --output-on-failure --no-tests=error \
    --output-junit "$report" "$@" > "$log" 2>&1 < /dev/null || status=$?
  if [[ ! -f $report ]]; then
    tail -n 40 "$log"
    echo "0 passed, 1 failed, 0 skipped"
    return 1
  fi
  # Failures with their output stand before the summary.
  if [[ $status -ne 0 ]]; then
    sed -n '/^[0-9]*% tests passed/q;p' "$log" |
      grep -v -E '^(Internal ctest|Test project)|^ *(Start +[0-9]+:|[0-9]+/[0-9]+ Test .* (Passed|\*\*\*Skipped) )' |
      tail -n 120
  fi
  sed -n '/^[0-9]*% tests passed/,$p' "$log"
  count_line "$report"
  return "$status"
}

# The counts of a JUnit report of ctest, as one plain line. A test whose program is missing has failed.
count_line() {
  local total passed skipped
  total=$(grep -c '<testcase ' "$1" || true)
  passed=$(grep -c '<testcase .*status="run"' "$1" || true)
  skipped=$(grep -c -E '<skipped message="SKIP_|<testcase .*status="disabled"' "$1" || true)
  echo "$passed passed, $((total - passed - skipped)) failed, $skipped skipped"
}
