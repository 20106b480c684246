// Half of a slice of a pin (body = 0) or of the bush around it (body = 1), axis along y, open on the planes
// x = 0 and y = 0.
//
//     gmsh -2 -format msh22 slice.geo -setnumber body 0 -o pin.msh
//     gmsh -2 -format msh22 slice.geo -setnumber body 1 -o bush.msh
//     gmsh -2 -format msh22 slice.geo -setnumber body 0 -setnumber degrees 5 -o pin_of_5_degrees.msh
DefineConstant[ body = {0, Name "body"}, degrees = {4, Name "degrees"} ];
mm = 0.001;
pin = 10 * mm;
clearance = 0.02 * mm;
width = 1 * mm;
// Elements of so many degrees in the zone, from below; larger ones above it.
step = degrees * Pi / 180;
zone = Ceil((body == 0 ? 64 : 60) / degrees);
above = body == 0 ? 5 : 9;
If (body == 0)
  inner = 1 * mm;
  outer = pin;
  layers = 8;
  ratio = 1.1;
Else
  inner = pin + clearance;
  outer = 80 * mm;
  layers = 8;
  ratio = 1.45;
EndIf

// Nodes at each angle on the inside (side 0) and the outside (side 1), at both ends (end 0 and 1).
last = zone * step;
count = zone + above;
For k In {0:count}
  a = k <= zone ? k * step : last + (k - zone) * (Pi - last) / above;
  For side In {0:1}
    r = side == 0 ? inner : outer;
    For end In {0:1}
      Point(1000 * side + 500 * end + k + 1) = {r * Sin(a), end * width, -r * Cos(a)};
    EndFor
    Line(4001 + 1000 * side + k) = {1000 * side + k + 1, 1000 * side + 500 + k + 1};
  EndFor
  Line(6001 + k) = {501 + k, 1501 + k};
EndFor
For k In {0:count - 1}
  For p In {0:1500:500}
    Line(p + k + 1) = {p + k + 1, p + k + 2};
  EndFor
  For side In {0:1}
    p = 1000 * side + k + 1;
    Curve Loop(p) = {p, p + 4001, -(p + 500), -(p + 4000)};
    Surface(p) = {p};
  EndFor
  Curve Loop(2001 + k) = {6001 + k, 1501 + k, -(6002 + k), -(501 + k)};
  Plane Surface(2001 + k) = {2001 + k};
EndFor

Transfinite Curve {1:count, 501:500 + count, 1001:1000 + count, 1501:1500 + count} = 2;
Transfinite Curve {4001:4001 + count, 5001:5001 + count} = 2;
Transfinite Curve {6001:6001 + count} = layers + 1 Using Progression (body == 0 ? 1 / ratio : ratio);
Transfinite Surface {1:count, 1001:1000 + count, 2001:2000 + count};
Recombine Surface {1:count, 1001:1000 + count, 2001:2000 + count};
// Outward is out of the solid.
ReverseMesh Surface {1001:1000 + count, 2001:2000 + count};

touching = 1000 * (1 - body);
Physical Surface("contact") = {touching + 1:touching + zone};
Physical Surface("rest") = {touching + zone + 1:touching + count};
Physical Surface("held") = {1001 - touching:1000 - touching + count};
Physical Surface("end") = {2001:2000 + count};
