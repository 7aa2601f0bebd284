# SPDX-License-Identifier: MIT
# Plot of the cab calibration; run it in the folder of the CSV files: gnuplot plots.gp
set datafile separator ","
set datafile columnheaders
set terminal pngcairo size 1200,860 font "DejaVu Sans,11"
set output "cab_response.png"
set grid xtics ytics lt 1 lc rgb "#d0d0d0" lw 0.8
set tics nomirror out
set border 3
set style line 1 lc rgb "#7f7f7f" lw 2.4
set style line 2 lc rgb "#1f4e79" lw 1.8
set style line 3 lc rgb "#c55a11" lw 1.8 dt 2
set style line 4 lc rgb "#548235" lw 1.8
set multiplot layout 2,2 margins 0.07,0.98,0.07,0.90 spacing 0.07,0.15 \
    title "Cab over road before and after trimming the vertical cab mounts, half truck, linearised at rest"
set logscale xy
set xrange [0.5:20]
set yrange [1e-5:100]
set xtics (0.5, 1, 2, 3, 5, 10, 20)
set format y "10^{%T}"
set xlabel "frequency [Hz]"
set arrow from 1.8, graph 0.28 to 1.8, graph 1 nohead dt 2 lc rgb "black" lw 1.2
set label "measured peak 1.8 Hz" at 1.9, graph 0.95 left font ",9"
do for [k=1:4] {
    variant = k <= 2 ? "linear" : "thesis_dampers"
    set title sprintf("%s, cab at its %s mounts", variant eq "linear" ? "linear dampers" : "dampers of the thesis", k % 2 ? "front" : "rear")
    set ylabel (k % 2 ? "|cab / road| [-]" : "")
    if (k % 2) { set key left bottom samplen 3 reverse Left noenhanced } else { unset key }
    plot for [s=1:4] sprintf("response_half_truck_%s.csv", variant) \
             using 1:(column(1+(k % 2 ? 0 : 4)+s)) with lines ls s title columnhead(1+(k % 2 ? 0 : 4)+s)
}
unset multiplot
