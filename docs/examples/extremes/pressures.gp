# docs/images/extremes_pressure.png, from the runs of pressures.toml:
#     jam_app sweep pressures.toml && gnuplot pressures.gp
# The last record of each run: pressure, volume fraction, contacts of the backbone, Cundall parameter.
last = "< tail -qn 1 runs/pressures/*/record.jsonl | sed -E " . \
    "'s/.*volume_fraction\":([^,]+),.*coordination_nr\":([^,]+),.*\"pressure\":\\[\\[([^,]+),.*\"cundall\":([^,]+),.*/\\3 \\1 \\2 \\4/' | sort -g"
set terminal pngcairo size 1500,480 font "sans,12"
set output "extremes_pressure.png"
set multiplot layout 1,3
set logscale x
set format x "10^{%T}"
set xlabel "applied pressure p / (k/D_{min})"
set grid lc rgb "#dddddd"
set key top left
set ylabel "volume fraction"
plot last using 1:2 with linespoints pt 7 lc rgb "#1f6fb4" notitle
set logscale y
set format y "10^{%T}"
set ylabel "Z_{nr} - 6"
plot [][1e-2:10] last using 1:($3-6) with linespoints pt 7 lc rgb "#1f6fb4" title "measured", \
    13.5*sqrt(x) lc rgb "#888888" dt 2 title "13.5 p^{1/2}"
set ylabel "Cundall parameter at the end"
plot [][1e-12:1e-4] last using 1:4 with linespoints pt 7 lc rgb "#1f6fb4" title "measured", \
    1e-6 lc rgb "#c0392b" title "stop.cundall", \
    4e-16/x lc rgb "#888888" dt 2 title "4 10^{-16} / p"
