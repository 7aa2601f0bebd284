# SPDX-License-Identifier: MIT
# Rigid truck with stiffened tires beside leaf friction; run it in the folder of the CSV files.
set datafile separator ","
set datafile columnheaders
set terminal pngcairo size 1350,1250 font "DejaVu Sans,11"
set output "thesis_revisited.png"
set grid xtics ytics lt 1 lc rgb "#d0d0d0" lw 0.8
set tics nomirror out
set border 3
set style line 1 lc rgb "#1f4e79" lw 1.8
set style line 2 lc rgb "#c55a11" lw 1.8
set style line 3 lc rgb "#7f7f7f" lw 1.5 dt (8,4)
array files[3]; array titles[3]
files[1] = "quarter_front"; titles[1] = "front quarter car, unsprung mass"
files[2] = "half_truck";    titles[2] = "half truck, front axle"
files[3] = "truck_3d";      titles[3] = "3D truck, front axle, left"
unset key
set multiplot layout 3,3 margins 0.06,0.985,0.09,0.925 spacing 0.065,0.1 \
    title "Front axle on the road simulator, with and without its damper: stiffened tires, as in the thesis, beside leaf-spring friction"
set logscale y
set format y "10^{%T}"
set xrange [0:22]
set yrange [1e-4:1e4]
do for [k=1:3] {
    do for [e=1:2] {
        unset arrow
        set arrow from 13.8, graph 0 to 13.8, graph 1 nohead dt 3 lc rgb "#1f4e79"
        set arrow from 11.8, graph 0 to 11.8, graph 1 nohead dt 3 lc rgb "#c55a11"
        set title titles[k].(e == 1 ? ": tires alone" : ": leaf friction")
        set xlabel (k == 3 ? "frequency [Hz]" : "")
        set ylabel (e == 1 ? "PSD [(m/s^2)^2/Hz]" : "") offset 1,0
        first = 2 + 2 * e
        plot for [c=0:1] "psd_".files[k].".csv" using 1:first+c with lines ls c+1
    }
    unset arrow
    if (k == 1) {
        unset logscale y
        set format y "%g"
        set title "leaf spring: friction over travel"
        set xrange [-6:6]
        set yrange [*:*]
        set xlabel "elongation [mm]"
        set ylabel "friction [kN]" offset 1,0
        plot "loop.csv" using ($1*1e3):($2/1e3) with lines ls 1
        set logscale y
        set format y "10^{%T}"
        set xrange [0:22]
        set yrange [1e-4:1e4]
    }
    if (k == 2) {
        unset logscale y
        set format y "%g"
        set title "half truck: peak over the sweep's amplitude"
        set xrange [2:30]
        set logscale x
        set xtics (3, 6, 12, 24)
        set yrange [6:16]
        set xlabel "amplitude at 1 Hz [mm]"
        set ylabel "front axle's peak [Hz]" offset 1,0
        plot for [c=1:2] "amplitude.csv" using ($1*1e3):(column(1+c)) with linespoints ls c pt 7
        unset logscale x
        set xtics autofreq
        set logscale y
        set format y "10^{%T}"
        set xrange [0:22]
        set yrange [1e-4:1e4]
    }
    if (k == 3) {
        set title "half truck, rear axle: three explanations"
        set xlabel "frequency [Hz]"
        set ylabel "" offset 1,0
        set arrow from 10, graph 0 to 10, graph 1 nohead dt 3 lc rgb "black"
        plot "psd_half_truck.csv" using 1:8 with lines ls 3, "" using 1:10 with lines ls 2, "" using 1:12 with lines ls 1
    }
}
# One legend below all panels.
unset logscale; unset border; unset tics; unset title; unset xlabel; unset ylabel; unset arrow
set lmargin at screen 0.02; set rmargin at screen 0.98; set bmargin at screen 0.005; set tmargin at screen 0.04
set xrange [0:1]
set yrange [0:1]
set key center center horizontal maxrows 1 samplen 4 width -2
plot NaN with lines ls 1 title "standard front damper (rear: friction)", \
     NaN with lines ls 2 title "no front damper (rear: tires alone)", \
     NaN with lines ls 3 title "original tires; dotted: measured peaks"
unset multiplot
