// An eighth of a hollow sphere of radii 1 and 2 m, open on the planes x = 0 and y = 0.
//
//     gmsh -2 octant.geo -o octant.msh
//
// n: elements along an eighth of a turn and through the wall.
n = 5;

Point(1) = {0, 0, 0};
For side In {0:1}
  r = 1 + side;
  p = 10 + 10 * side;
  h = r / Sqrt(2);
  Point(p + 1) = {r, 0, 0};
  Point(p + 2) = {0, r, 0};
  Point(p + 3) = {0, 0, r};
  Point(p + 4) = {h, h, 0};
  Point(p + 5) = {0, h, h};
  Point(p + 6) = {h, 0, h};
  Point(p + 7) = {r / Sqrt(3), r / Sqrt(3), r / Sqrt(3)};
  Circle(p + 1) = {p + 1, 1, p + 4};
  Circle(p + 2) = {p + 4, 1, p + 2};
  Circle(p + 3) = {p + 2, 1, p + 5};
  Circle(p + 4) = {p + 5, 1, p + 3};
  Circle(p + 5) = {p + 3, 1, p + 6};
  Circle(p + 6) = {p + 6, 1, p + 1};
  Circle(p + 7) = {p + 4, 1, p + 7};
  Circle(p + 8) = {p + 5, 1, p + 7};
  Circle(p + 9) = {p + 6, 1, p + 7};
  Curve Loop(p + 1) = {p + 1, p + 7, -(p + 9), p + 6};
  Curve Loop(p + 2) = {p + 2, p + 3, p + 8, -(p + 7)};
  Curve Loop(p + 3) = {p + 4, p + 5, p + 9, -(p + 8)};
  For patch In {1:3}
    Surface(p + patch) = {p + patch} In Sphere {1};
  EndFor
EndFor

// The plane z = 0.
Line(41) = {11, 21};
Line(42) = {14, 24};
Line(43) = {12, 22};
Curve Loop(41) = {41, 21, -42, -11};
Curve Loop(42) = {42, 22, -43, -12};
Plane Surface(41) = {41};
Plane Surface(42) = {42};

Transfinite Curve {11:19, 21:29} = n + 1;
Transfinite Curve {41:43} = n + 1 Using Progression 2^(1 / n);
Transfinite Surface {11:13, 21:23, 41, 42};
Recombine Surface {11:13, 21:23, 41, 42};
// Outward is out of the wall.
ReverseMesh Surface {11:13, 41, 42};
Physical Surface("inside") = {11:13};
Physical Surface("outside") = {21:23};
Physical Surface("z0") = {41, 42};
