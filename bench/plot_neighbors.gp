# SPDX-License-Identifier: BSD-3-Clause
# Figures of bench_neighbors: gnuplot -e "methods='methods.csv'; collections='collections.csv'; out='bench/results/'" bench/plot_neighbors.gp
set datafile separator ","
set terminal pngcairo size 1000,700 font "sans,13"
set key top left
set grid lc rgb "#dddddd"
set logscale xy

set output out."neighbor_methods.png"
set title "Binary packings, f_S = 0.5, one thread"
set xlabel "size ratio"
set ylabel "build, ns a particle"
set yrange [20:*]
of(name) = sprintf("< grep '^%s,' %s", name, methods)
plot of("default") using 2:6 with linespoints lw 2 pt 5 lc rgb "#2a9d4a" title "default", \
     of("multi-old") using 2:6 with linespoints lw 2 pt 9 lc rgb "#d1423f" title "multi-old", \
     of("multi") using 2:6 with linespoints lw 2 pt 7 lc rgb "#2468b4" title "multi", \
     of("multi") using 2:7 with linespoints lw 1 dt 2 pt 6 lc rgb "#777777" title "one force evaluation", \
     [2:20] 3*x**3 with lines dt 3 lc rgb "black" title "lambda^3"

set output out."neighbor_collections.png"
set title "Power-law packings, alpha = 1, multi, one thread"
set xlabel "collections"
set key top right
set xrange [0.9:22]
set yrange [50:*]
at(lambda, spacing) = sprintf("< grep '^multi,%s,[0-9]*,[0-9]*,%s' %s | sort -t, -k4n | awk -F, '!seen[$4]++'", lambda, spacing, collections)
colors = "#2468b4 #2a9d4a #d98c1f #d1423f"
lambdas = "10 20 50 100"
plot for [k=1:4] at(word(lambdas,k), "geometric") using 4:6 with linespoints lw 2 pt 7 lc rgb word(colors,k) title "geometric, lambda ".word(lambdas,k), \
     for [k=1:4] at(word(lambdas,k), "linear") using 4:6 with linespoints lw 2 dt 2 pt 6 lc rgb word(colors,k) title "linear, lambda ".word(lambdas,k), \
     for [k=1:4] at(word(lambdas,k), "automatic") using 4:6 with points pt 3 ps 3 lw 2 lc rgb word(colors,k) notitle
