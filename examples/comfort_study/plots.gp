# SPDX-License-Identifier: MIT
# One page of the comfort study; run it in the folder of the CSV files: gnuplot plots.gp
set datafile separator ","
set datafile columnheaders
set datafile missing NaN
set terminal pngcairo size 1350,900 font "DejaVu Sans,11"
set output "comfort_study.png"
set grid xtics ytics lt 1 lc rgb "#d0d0d0" lw 0.8
set tics nomirror out
set border 3
colours = "#1f4e79 #c55a11 #7f7f7f"
dampers = "standard harder undamped"
classes = "B C"
do for [d=1:3] { set style line d lc rgb word(colours, d) lw 1.8 }
set multiplot layout 2,3 margins 0.055,0.985,0.125,0.9 spacing 0.06,0.13 \
    title "Reference tractor on ISO 8608 roads, 240 s at each speed; bars: one standard error by chance"
# Rows of one truck, class and damper; others are missing. Dampers stand a little beside each other.
pick(c, class, damper) = strcol("truck") eq "thesis_dampers" && strcol("class") eq class && \
    strcol("damper") eq damper ? column(c) : NaN
array quantity[3] = ["cab_z_wk", "front_dlc", "rear_dlc"]
array heading[3] = ["cab floor, vertical, weighted Wk, dampers of the thesis", \
    "left front tire, dampers of the thesis", "left rear tire, dampers of the thesis"]
array unit[3] = ["weighted RMS [m/s^2]", "dynamic load coefficient [-]", "dynamic load coefficient [-]"]
array top[3] = [2.2, 0.7, 0.4]
unset key
set xrange [45:95]
set xtics (50, 70, 90)
set xlabel "speed [km/h]"
do for [p=1:3] {
    set title heading[p]
    set ylabel unit[p] offset 1,0
    set yrange [0:top[p]]
    plot for [k=1:2] for [d=1:3] "comfort_table.csv" \
        using (column("speed_km_h") + 0.6 * (d - 2)):(pick(quantity[p], word(classes, k), word(dampers, d))):(pick(quantity[p]."_error", word(classes, k), word(dampers, d))) \
        with yerrorlines ls d dt k pt (k == 1 ? 7 : 6) ps 0.9
}
set xtics autofreq
set logscale xy
set xrange [0.3:50]
set yrange [1e-7:10]
set format y "10^{%T}"
set xtics (0.3, 0.5, 1, 2, 5, 10, 20, 50)
set xlabel "frequency [Hz]"
set ylabel "PSD [(m/s^2)^2/Hz]" offset 1,0
set key bottom left Left reverse samplen 2 spacing 1.1 width -2
set title "cab floor, vertical: linear truck, class B, 70 km/h"
plot "psd_time.csv" using 1:3 with lines lc rgb "#e08a4a" lw 1.6 title "time steps, Welch", \
     "psd_frequency.csv" using 1:2 with lines lc rgb "black" lw 1.2 title "by spectra, no run"
set ylabel ""
set title "the same with the dampers of the thesis"
plot "psd_time.csv" using 1:2 with lines lc rgb "#1f4e79" lw 1.6 title "dampers of the thesis, time steps", \
     "psd_frequency.csv" using 1:2 with lines lc rgb "black" lw 1.2 title "linear dampers, by spectra"
unset logscale
unset key
set format y "%g"
set title "linear truck: time steps less spectra, class B"
set xlabel ""
set ylabel "difference [standard errors]" offset 1,0
set xrange [0.4:8.6]
set yrange [-3.2:3.2]
set xtics ("cab\nx" 1, "cab\ny" 2, "cab\nz" 3, "sum" 4, "front\nDLC" 5, "rear\nDLC" 6, "front\ntravel" 7, "rear\ntravel" 8) font ",9"
set arrow from 0.4,0 to 8.6,0 nohead lc rgb "black" lw 1
deviation(damper) = strcol("class") eq "B" && strcol("damper") eq damper ? column("deviation_in_errors") : NaN
plot for [d=1:3] "agreement.csv" using (column("number") + 0.2 * (d - 2)):(deviation(word(dampers, d))) \
    with points ls d pt 7 ps 0.9
# One legend below all panels.
unset border; unset tics; unset title; unset xlabel; unset ylabel; unset arrow; unset grid
set lmargin at screen 0.02; set rmargin at screen 0.98; set bmargin at screen 0.005; set tmargin at screen 0.04
set xrange [0:1]
set yrange [0:1]
set key center center horizontal samplen 4 width 1
plot for [d=1:3] NaN with lines ls d title word(dampers, d)." front damper", \
    NaN with linespoints lc rgb "black" pt 7 title "class B", \
    NaN with linespoints lc rgb "black" dt 2 pt 6 title "class C"
unset multiplot
