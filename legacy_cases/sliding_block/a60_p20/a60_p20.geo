<?xml version="1.0" standalone="no"?>
<!DOCTYPE DDA SYSTEM "geometry.dtd">
<Berkeley:DDA xmlns:Berkeley="http://www.tsoft.com/~bdoolin/dda">
<!-- geometry -->
<Berkeley:Geometry>
<Berkeley:Edgenodedist distance="0.01"/>
<Jointlist>
<Joint type="1"> -1.74071106160672 -1.005 0.00866025403784439 0.005 </Joint>
<Joint type="1"> -1.73705080756888 -0.991339745962156 8.27294919243113 -18.3291683297266 </Joint>
<Joint type="1"> 8.25928893839328 -18.3255080756888 10.0086602540378 -17.3155080756888 </Joint>
<Joint type="1"> -0.005 0.00866025403784439 10.005 -17.3291683297266 </Joint>
<Joint type="1"> 1.99133974596216 -3.46910161513775 2.87468565782228 -2.95910161513775 </Joint>
<Joint type="1"> 2.99133974596216 -5.20115242270663 3.87468565782228 -4.69115242270663 </Joint>
<Joint type="1"> 2.86102540378444 -2.95544136109991 3.87102540378444 -4.70481267674448 </Joint>
</Jointlist>
<Fixedpointlist>
<Point> -0.799038105676658 -1.61602540378444 </Point>
<Point> 8.20096189432334 -17.2044826719043 </Point>
<Point> 9.06698729810778 -16.7044826719043 </Point>
<Point> 0.0669872981077808 -1.11602540378444 </Point>
</Fixedpointlist>
<Measuredpointlist>
<Point> 2.93301270189222 -4.08012701892219 </Point>
</Measuredpointlist>
</Berkeley:Geometry>
</Berkeley:DDA>
