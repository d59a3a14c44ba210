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
  gnuplot "$script" 2>/dev/null
  rm -f "$script"
}

# jpeg_of PNG JPEG: pixel by pixel; noisy frames take four times as much room as PNG.
jpeg_of() {
  gnuplot 2>/dev/null <<EOF
set terminal jpeg size $(od -An -t u4 --endian=big -j 16 -N 8 "$1" | awk '{ print $1 "," $2 }')
set output '$2'
set lmargin at screen 0; set rmargin at screen 1; set tmargin at screen 1; set bmargin at screen 0
unset tics; unset border; unset key; set autoscale fix
plot '$1' binary filetype=png with rgbimage
EOF
}

# panel_svg OUTPUT WIDTH HEIGHT (LABEL PNG)...: the same under each other, the pictures whole within.
panel_svg() {
  local output=$1 width=$2 height=$3 y=0 picture=$1.jpg
  shift 3
  {
    echo "<svg xmlns='http://www.w3.org/2000/svg' width='$width' height='$((height * $# / 2))' font-family='DejaVu Sans, sans-serif'>"
    echo "<rect width='100%' height='100%' fill='white'/>"
    while [ $# -gt 1 ]; do
      echo "<text x='$((width / 2))' y='$((y + 20))' font-size='14' text-anchor='middle'>$1</text>"
      jpeg_of "$2" "$picture"
      echo "<image x='0' y='$((y + 30))' width='$width' height='$((height - 30))' href='data:image/jpeg;base64,$(base64 -w 0 "$picture")'/>"
      y=$((y + height))
      shift 2
    done
    echo "</svg>"
  } > "$output.svg"
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
flight fig5a lit_wide --method paper --time 8 --still 7
flight fig5b wide_8m --method paper --dust 0.1 --time 12 --still 10
flight fig5c lit_narrow --method paper --time 4 --still 3
flight fig5d narrow_2m --method paper --time 4 --still 3
still() { find "$work/figures/$1" -name 'still_*.png' | sort | head -n 1; }
later_still() { find "$work/figures/$1" -name 'still_*.png' | sort | tail -n 1; }
fig5=("a) extra lamp in a wide tunnel" "$(still fig5a)" "b) dust of 0.1 1/m in a wide tunnel" "$(still fig5b)"
  "c) extra lamp in a narrow tunnel" "$(still fig5c)" "d) narrow tunnel" "$(still fig5d)")
panel "$work/figures/fig5" 1 1000 400 "${fig5[@]}"
panel_svg "$work/figures/fig5" 1000 400 "${fig5[@]}"
# Fig. 6: 40 lux.
flight fig6 s_bend --method paper --lamp dim_40lux --time 12 --still 4 --still 10
fig6=("40 lux at 1 m, S-bend, 4 s" "$(still fig6)" "40 lux at 1 m, S-bend, 10 s" "$(later_still fig6)")
panel "$work/figures/fig6" 1 1000 400 "${fig6[@]}"
panel_svg "$work/figures/fig6" 1000 400 "${fig6[@]}"
for name in fig5 fig6; do copy_figure "$work/figures/$name" "$name"; done
