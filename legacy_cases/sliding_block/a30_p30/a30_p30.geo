<?xml version="1.0" standalone="no"?>
<!DOCTYPE DDA SYSTEM "geometry.dtd">
<Berkeley:DDA xmlns:Berkeley="http://www.tsoft.com/~bdoolin/dda">
<!-- geometry -->
<Berkeley:Geometry>
<Berkeley:Edgenodedist distance="0.01"/>
<Jointlist>
<Joint type="1"> -1.005 -1.74071106160672 0.005 0.00866025403784439 </Joint>
<Joint type="1"> -1.00866025403784 -1.72705080756888 16.3291683297266 -11.7370508075689 </Joint>
<Joint type="1"> 16.3155080756888 -11.7407110616067 17.3255080756888 -9.99133974596215 </Joint>
<Joint type="1"> -0.00866025403784439 0.005 17.3291683297266 -10.005 </Joint>
<Joint type="1"> 3.45910161513775 -2.00866025403784 3.96910161513775 -1.12531434217772 </Joint>
<Joint type="1"> 5.19115242270663 -3.00866025403784 5.70115242270663 -2.12531434217772 </Joint>
<Joint type="1"> 3.95544136109991 -1.12897459621556 5.70481267674448 -2.13897459621556 </Joint>
</Jointlist>
<Fixedpointlist>
<Point> 0.116025403784439 -1.79903810567666 </Point>
<Point> 15.7044826719043 -10.7990381056767 </Point>
<Point> 16.2044826719043 -9.93301270189222 </Point>
<Point> 0.616025403784439 -0.933012701892219 </Point>
</Fixedpointlist>
<Measuredpointlist>
<Point> 4.58012701892219 -2.06698729810778 </Point>
</Measuredpointlist>
</Berkeley:Geometry>
</Berkeley:DDA>
