# The paper's figures for docs/: sourced by scripts/results, which has set adit, work, quick, practice, models.
# shellcheck shell=bash
# shellcheck disable=SC2154

figures=docs/figures

# flight NAME ARGUMENT...: one flight with its figures, unless it is there already.
flight() {
  local place=$work/figures/$1 name=$1
  shift
  if [ -f "$place/summary.json" ] && [ "$(cat "$place/arguments" 2>/dev/null)" = "$*" ]; then return 0; fi
  rm -rf "$place"
  mkdir -p "$place"
  echo "figure: $name"
  "$adit" fly "$@" --out "$place" --quiet > "$place/log" 2>&1 || { echo "  failed: $(tail -n 1 "$place/log")"; return 1; }
  echo "$*" > "$place/arguments"
}

# panel OUTPUT COLUMNS WIDTH HEIGHT (LABEL PNG)...: pictures under each other and beside each other, with labels.
panel() {
  local output=$1 columns=$2 width=$3 height=$4 script
  shift 4
  local count=$(($# / 2))
  local lines=$(((count + columns - 1) / columns))
  script=$(mktemp)
  {
    echo "set terminal pngcairo size $((width * columns)),$((height * lines)) font 'DejaVu Sans,13' background rgb 'white'"
    echo "set output '$output.png'"
    echo "set multiplot layout $lines,$columns"
    echo "set lmargin 1; set rmargin 1; set tmargin 2.2; set bmargin 0.5"
    echo "unset tics; unset border; unset key; set size ratio -1; set autoscale fix"
    while [ $# -gt 1 ]; do
      echo "set title '$1'"
      echo "plot '$2' binary filetype=png with rgbimage"
      shift 2
    done
    echo "unset multiplot"
  } > "$script"
  sed -e "s/pngcairo/svg/" -e "s/$(basename "$output").png/$(basename "$output").svg/" "$script" > "$script.svg"
  gnuplot "$script" 2>/dev/null && gnuplot "$script.svg" 2>/dev/null
  rm -f "$script" "$script.svg"
}

copy_figure() { cp "$1.png" "$figures/$2.png" && cp "$1.svg" "$figures/$2.svg"; }

# Fig. 3: the paper's own run where its world is there, else our copy of its layout.
if [ -f "$practice" ]; then
  flight fig3 --world "$practice" --models "$models" --time 300 "${small[@]}" && copy_figure "$work/figures/fig3/fig3" fig3
else
  flight fig3 practice_2 --time 300 "${small[@]}" && copy_figure "$work/figures/fig3/fig3" fig3
fi
# Fig. 4: the S-bend at the paper's speed.
flight fig4 s_bend --speed 0.2 --time 300 "${small[@]}" && copy_figure "$work/figures/fig4/fig4" fig4
# Fig. 5: extra lamp and dust in the wide, extra lamp in the narrow, the narrow as it is.
flight fig5a lit_wide --time 8 --still 7
flight fig5b wide_8m --dust 0.1 --time 12 --still 10
flight fig5c lit_narrow --time 4 --still 3
flight fig5d narrow_2m --time 4 --still 3
still() { find "$work/figures/$1" -name 'still_*.png' | sort | head -n 1; }
panel "$work/figures/fig5" 1 1000 400 "a) extra lamp in a wide tunnel" "$(still fig5a)" \
  "b) dust of 0.1 1/m in a wide tunnel" "$(still fig5b)" "c) extra lamp in a narrow tunnel" "$(still fig5c)" \
  "d) narrow tunnel" "$(still fig5d)"
# Fig. 6: 40 lux.
flight fig6 s_bend --lamp dim_40lux --time 12 --still 4 --still 10
panel "$work/figures/fig6" 1 1000 400 "40 lux at 1 m, S-bend, 4 s" "$(find "$work/figures/fig6" -name 'still_*' | sort | head -n 1)" \
  "40 lux at 1 m, S-bend, 10 s" "$(find "$work/figures/fig6" -name 'still_*' | sort | tail -n 1)"
# Their SVG is the same pixels in three times the bytes: it stays in the work folder.
cp "$work/figures/fig5.png" "$work/figures/fig6.png" "$figures/"
