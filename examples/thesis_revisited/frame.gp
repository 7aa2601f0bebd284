# SPDX-License-Identifier: MIT
# The truck with its frame and with a rigid one; run it in the folder of the CSV files.
set datafile separator ","
set datafile columnheaders
set terminal pngcairo size 1350,820 font "DejaVu Sans,11"
set output "frame.png"
set grid xtics ytics lt 1 lc rgb "#d0d0d0" lw 0.8
set tics nomirror out
set border 3
set style line 1 lc rgb "#1f4e79" lw 1.8
set style line 2 lc rgb "#c55a11" lw 1.8
array titles[5]; array measured[5]
titles[1] = "frame at front cab mount"; measured[1] = 10.4
titles[2] = "frame above rear axle";    measured[2] = 10
titles[3] = "front axle";               measured[3] = 13.8
titles[4] = "rear axle";                measured[4] = 10
titles[5] = "cab at front mount";       measured[5] = 1.8
unset key
set logscale y
set format y "10^{%T}"
set xrange [0:22]
set yrange [1e-4:10]
set multiplot layout 2,3 margins 0.06,0.985,0.09,0.9 spacing 0.055,0.14 \
    title "4x2 tractor with leaf friction on the road simulator: flexible ladder frame beside a rigid one"
do for [k=1:5] {
    unset arrow
    set arrow from measured[k], graph 0 to measured[k], graph 1 nohead dt 3 lc rgb "black"
    set title titles[k]
    set xlabel (k >= 4 ? "frequency [Hz]" : "")
    set ylabel (k % 3 == 1 ? "PSD [(m/s^2)^2/Hz]" : "") offset 1,0
    plot for [c=0:1] "frame_psd.csv" using 1:(column(2*k+c)) with lines ls c+1
}
unset logscale; unset border; unset tics; unset title; unset xlabel; unset ylabel; unset arrow
set key center center samplen 4
set xrange [0:1]
set yrange [0:1]
plot NaN with lines ls 1 title "flexible frame", NaN with lines ls 2 title "rigid frame", \
     NaN with lines dt 3 lc rgb "black" title "measured peak"
unset multiplot
