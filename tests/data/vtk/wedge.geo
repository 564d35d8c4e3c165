one wedge
written by hand
node id assign
element id assign
part
         1
body
coordinates
         6
 0.00000e+00
 1.00000e+00
 0.00000e+00
 0.00000e+00
 1.00000e+00
 0.00000e+00
 0.00000e+00
 0.00000e+00
 1.00000e+00
 0.00000e+00
 0.00000e+00
 1.00000e+00
 0.00000e+00
 0.00000e+00
 0.00000e+00
 2.00000e+00
 2.00000e+00
 2.00000e+00
penta6
         1
         1         2         3         4         5         6
